// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "base/text/counted.hpp"
#include "base/text/suggest.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3804_moveit_controller_file {
namespace {

constexpr std::array<std::string_view, 3> kTypes = {"FollowJointTrajectory", "GripperCommand",
                                                    "ParallelGripperCommand"};

void check_type(yaml::View controller, Findings& findings) {
  const yaml::View type = controller.find("type");
  if (!type) {
    findings
        .report(controller.key_span(), "controller " + quoted(controller.key()) + " has no `type`")
        .help("write FollowJointTrajectory, GripperCommand or ParallelGripperCommand");
    return;
  }
  if (!type.is_scalar() || std::find(kTypes.begin(), kTypes.end(), type.text()) != kTypes.end()) {
    return;
  }
  const auto near = only_nearest(type.text(), kTypes);
  Diagnostic& found =
      findings.report(type.span(), "controller " + quoted(controller.key()) +
                                       " has the unknown type " + quoted(type.text()));
  found.help(near ? "did you mean " + quoted(*near) + "?"
                  : "write FollowJointTrajectory, GripperCommand or ParallelGripperCommand");
  if (near) found.fixes.push_back({Applicability::unsafe, {{type.span(), std::string(*near)}}});
}

void check_controller(yaml::View controller, Findings& findings) {
  check_type(controller, findings);
  const yaml::View joints = controller.find("joints");
  if (!controller.find("action_ns")) {
    findings
        .report(controller.key_span(),
                "controller " + quoted(controller.key()) + " has no `action_ns`")
        .help("write the name of the action below the controller, such as follow_joint_trajectory");
  }
  if (!joints || !joints.is_sequence() || joints.size() == 0) {
    findings
        .report(controller.key_span(),
                "controller " + quoted(controller.key()) + " has no list `joints`")
        .help("write the joints of the controller");
    return;
  }
  const yaml::View parallel = controller.find("parallel");
  if (parallel && parallel.is_scalar() && parallel.boolean() == true && joints.size() != 2) {
    findings
        .report(joints.span(), "the parallel gripper " + quoted(controller.key()) + " has " +
                                   counted(joints.size(), "joint"))
        .help("write two joints, or delete `parallel`");
  }
}

/// Whether a mapping has controllers of MoveIt.
bool has_controllers(yaml::View manager) {
  return std::any_of(manager.begin(), manager.end(), [](yaml::View member) {
    return member.is_mapping() && member.find("action_ns") && member.find("joints");
  });
}

/// The mapping with `controller_names`, at any depth.
void check_manager(yaml::View root, Findings& findings) {
  const yaml::View names = root.find("controller_names");
  if (!names) {
    for (const yaml::View member : root) {
      if (!member.is_mapping() || member.is_repeated()) continue;
      const bool is_manager = member.key() == "moveit_simple_controller_manager";
      if (!is_manager || !has_controllers(member) || member.find("controller_names")) {
        check_manager(member, findings);
        continue;
      }
      findings
          .report(member.key_span(), "there is no list `controller_names`, so that MoveIt uses "
                                     "none of these controllers")
          .help("write `controller_names` with the names of the controllers");
    }
    return;
  }
  if (!names.is_sequence()) {
    findings.report(names.place(), "`controller_names` is not a list")
        .help("write a list of the names of controllers");
    return;
  }
  for (const yaml::View name : names) {
    if (!name.is_scalar()) continue;
    const yaml::View controller = root.find(name.text());
    if (controller && controller.is_mapping()) {
      check_controller(controller, findings);
      continue;
    }
    std::vector<std::string_view> known;
    for (const yaml::View member : root) {
      if (member.is_mapping()) known.push_back(member.key());
    }
    Diagnostic& found = findings.report(name.span(), "there is no section for the controller " +
                                                         quoted(name.text()));
    const auto near = findings.suggest(name.text(), known);
    found.help(near ? "did you mean " + quoted(*near) + "?"
                    : "write a mapping " + quoted(name.text()) + " with `type` and `joints`");
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_file(companions, CompanionKind::moveit_controllers,
                [&](const Companion& file, yaml::View root) {
                  if (file.is_ros2) check_manager(root, findings);
                });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and does not use the controller",
     "moveit2 moveit_simple_controller_manager.cpp:107-224"},
};

}  // namespace

extern constinit const Rule sml3804_moveit_controller{
    .id = "SML3804",
    .name = "moveit-controller",
    .severity = Severity::error,
    .summary = "A controller in moveit_controllers.yaml has no section, or an incomplete one.",
    .remedy = "Write a section with `type` and `joints` for each controller.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3804_moveit_controller_file
