// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
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

/// The names that the controllers of ros2_controllers give to their actions.
void check_action(yaml::View controller, Findings& findings) {
  constexpr std::array<std::string_view, 2> kActions = {"follow_joint_trajectory", "gripper_cmd"};
  const yaml::View action = controller.find("action_ns");
  if (!action || !action.is_scalar()) return;
  const auto near = near_name(action.text(), kActions);
  if (!near) return;
  Diagnostic& found = findings.report(action.span(), "the controller " + quoted(controller.key()) +
                                                         " has no action " + quoted(action.text()));
  found.help("did you mean " + quoted(*near) + "?");
  found.fixes.push_back({Applicability::unsafe, {{action.span(), std::string(*near)}}});
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
      if (!controller || !controller.is_mapping()) continue;
      check_joints(controller, known->second, findings);
      check_action(controller, findings);
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
/// The texts of a list; empty if it is not one.
std::set<std::string_view> texts_of(yaml::View list) {
  std::set<std::string_view> texts;
  if (!list || !list.is_sequence()) return texts;
  for (const yaml::View one : list) {
    if (one.is_scalar()) texts.insert(one.text());
  }
  return texts;
}

/// ros_control of ROS 1: `arm: {type: position_controllers/JointTrajectoryController, joints:
/// ...}`.
std::map<std::string_view, std::set<std::string_view>>
ros1_controllers(const Companions& companions) {
  std::map<std::string_view, std::set<std::string_view>> all;
  for_each_file(
      companions, CompanionKind::moveit_controllers, [&](const Companion&, yaml::View root) {
        for (const yaml::View member : root) {
          const yaml::View type = member.is_mapping() ? member.find("type") : yaml::View();
          if (!type || !type.is_scalar()) continue;
          if (type.text().ends_with("/JointTrajectoryController"))
            all[member.key()] = texts_of(member.find("joints"));
        }
      });
  return all;
}

/// A name that no controller has, of an entry with exactly the joints of one: the setup assistant
/// of MoveIt writes `name: ""`.
void check_ros1(yaml::View root,
                const std::map<std::string_view, std::set<std::string_view>>& declared,
                Findings& findings) {
  const yaml::View list = root.find("controller_list");
  if (!list || !list.is_sequence()) return;
  for (const yaml::View entry : list) {
    const yaml::View name = entry.is_mapping() ? entry.find("name") : yaml::View();
    const yaml::View action = entry.is_mapping() ? entry.find("action_ns") : yaml::View();
    if (!name || !name.is_scalar() || !action || !action.is_scalar()) continue;
    std::string_view written = name.text();
    while (written.ends_with('/')) written.remove_suffix(1);
    // Drivers of ROS-Industrial have an action `joint_trajectory_action` without a controller.
    if (action.text() != "follow_joint_trajectory" || is_placeholder(written)) continue;
    if (declared.contains(without_namespace(written))) continue;
    const std::set<std::string_view> joints = texts_of(entry.find("joints"));
    const auto same = std::find_if(declared.begin(), declared.end(), [&](const auto& one) {
      return !joints.empty() && one.second == joints;
    });
    if (same == declared.end()) continue;
    Diagnostic& found = findings.report(
        name.place(), "MoveIt looks for the action " +
                          quoted(std::string(written) + "/follow_joint_trajectory") +
                          ", but the controller with these joints is " + quoted(same->first));
    found.help("write `name: " + std::string(same->first) + "`");
    found.fixes.push_back({Applicability::unsafe, {{name.place(), std::string(same->first)}}});
  }
}

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
  if (const auto old = ros1_controllers(companions); !old.empty()) {
    for_each_file(companions, CompanionKind::moveit_controllers,
                  [&](const Companion&, yaml::View root) { check_ros1(root, old, findings); });
  }
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
     "moveit and moveit2 moveit_simple_controller_manager.cpp action_based_controller_handle.hpp"},
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
