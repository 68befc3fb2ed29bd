// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/quoted.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/moveit_files.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3805_moveit_controller_unknown_file {
namespace {

constexpr Circumstance kJoints{"joints"};
constexpr Circumstance kGroup{"group"};

/// A controller of ros2_control.
struct Declared {
  std::set<std::string_view> joints;
  bool has_unknown = false;  ///< joints that the robot does not have, which SML3701 reports
  Span place;
};

std::map<std::string_view, Declared> declared_in(const LinkedModel& model,
                                                 const Companions& companions) {
  std::map<std::string_view, Declared> all;
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) {
      Declared& declared = all[one.name];
      declared.place = one.place;
      for (const yaml::View joint : one.list("joints")) {
        declared.joints.insert(joint.text());
        if (!model.joint_index(joint.text())) declared.has_unknown = true;
      }
    }
  });
  return all;
}

/// "arm/trajectory" is the controller `trajectory` of the controller_manager in the namespace arm.
std::string_view without_namespace(std::string_view name) {
  const std::size_t slash = name.rfind('/');
  return slash == std::string_view::npos ? name : name.substr(slash + 1);
}

void check_joints(yaml::View controller, const Declared& declared, Findings& findings) {
  const yaml::View joints = controller.find("joints");
  if (!joints || !joints.is_sequence() || declared.joints.empty() || declared.has_unknown) return;
  std::string missing;
  for (const yaml::View joint : joints) {
    if (!joint.is_scalar() || is_placeholder(joint.text())) return;
    if (declared.joints.contains(joint.text())) continue;
    missing += (missing.empty() ? "" : ", ") + quoted(joint.text());
  }
  const bool has_placeholder =
      std::any_of(declared.joints.begin(), declared.joints.end(), is_placeholder);
  if (missing.empty() || has_placeholder) return;
  findings
      .report(joints.place(), "MoveIt sends " + shortened(missing, 200) + " to the controller " +
                                  quoted(controller.key()) + ", which does not have it")
      .label(declared.place, "the controller is declared here")
      .help("write the same joints in both files")
      .when(kJoints);
}

void check_manager(yaml::View root, const std::map<std::string_view, Declared>& declared,
                   Findings& findings) {
  const yaml::View names = root.find("controller_names");
  if (!names) {
    for (const yaml::View member : root) {
      if (member.is_mapping() && !member.is_repeated()) check_manager(member, declared, findings);
    }
    return;
  }
  if (!names.is_sequence()) return;
  for (const yaml::View name : names) {
    if (!name.is_scalar() || is_placeholder(name.text())) continue;
    const auto known = declared.find(without_namespace(name.text()));
    const yaml::View controller = root.find(name.text());
    if (known != declared.end()) {
      if (controller && controller.is_mapping()) check_joints(controller, known->second, findings);
      continue;
    }
    if (!controller) continue;  // SML3804
    std::vector<std::string_view> candidates;
    for (const auto& [one, where] : declared) candidates.push_back(one);
    Diagnostic& found = findings.report(
        name.span(), "no controllers.yaml declares the controller " + quoted(name.text()));
    const auto near = findings.suggest(name.text(), candidates);
    found.help(near ? "did you mean " + quoted(*near) + "?"
                    : "declare it below `controller_manager`, or delete it here");
  }
}

/// Controllers whose joints are in no group, so that no plan moves them.
class Groups {
 public:
  Groups(const LinkedModel& model, const srdf::Description& srdf) : model_(model) {
    for (const srdf::Group& group : srdf.groups) groups_.push_back(joints_of(model, srdf, group));
  }

  void check(yaml::View root, Findings& findings) const {
    const yaml::View names = root.find("controller_names");
    for (const yaml::View member : root) {
      if (!member.is_mapping() || member.is_repeated()) continue;
      if (!names) {
        check(member, findings);
        continue;
      }
      const yaml::View joints = member.find("joints");
      if (joints && joints.is_sequence() && joints.size() > 0)
        check_joints(member, joints, findings);
    }
  }

 private:
  void check_joints(yaml::View controller, yaml::View joints, Findings& findings) const {
    for (const yaml::View joint : joints) {
      if (!joint.is_scalar() || !model_.joint_index(joint.text())) return;
      const bool is_in_one = std::any_of(groups_.begin(), groups_.end(), [&](const auto& group) {
        return !group.is_complete || group.contains(model_, joint.text());
      });
      if (is_in_one) return;
    }
    Diagnostic& found = findings.report(controller.key_span(),
                                        "no group of the SRDF has a joint of the controller " +
                                            quoted(controller.key()));
    found.severity = Severity::info;
    found.when(kGroup);
    found.help("add a group with these joints, or delete the controller");
  }

  const LinkedModel& model_;
  std::vector<GroupJoints> groups_;
};

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Companion* only = model.robot ? only_srdf(companions) : nullptr;
  for_each_file(companions, CompanionKind::moveit_controllers,
                [&](const Companion& file, yaml::View root) {
                  if (only == nullptr || file.folder != only->folder) return;
                  Groups(model, *only->srdf).check(root, findings);
                });
  const std::map<std::string_view, Declared> declared = declared_in(model, companions);
  if (declared.empty()) return;  // they may be on the robot
  for_each_file(companions, CompanionKind::moveit_controllers,
                [&](const Companion& file, yaml::View root) {
                  if (file.is_ros2) check_manager(root, declared, findings);
                });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::ignores, "never uses the controller",
     "moveit2 trajectory_execution_manager.cpp selectControllers", when(kGroup)},
    {&readers::moveit, Effect::loses, "sends no motion for the joint",
     "moveit2 moveit_simple_controller_manager.cpp", when(kJoints)},
    {&readers::moveit, Effect::loses, "finds no action server, and cannot execute a plan",
     "moveit2 moveit_simple_controller_manager.cpp action_based_controller_handle.hpp"},
};

}  // namespace

extern constinit const Rule sml3805_moveit_controller_unknown{
    .id = "SML3805",
    .name = "moveit-controller-unknown",
    .severity = Severity::warning,
    .summary = "A controller of moveit_controllers.yaml is not one of ros2_control, or has other "
               "joints there.",
    .remedy = "Use the same names and joints in both files.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3805_moveit_controller_unknown_file
