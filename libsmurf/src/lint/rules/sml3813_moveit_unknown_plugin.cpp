// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3813_moveit_unknown_plugin_file {
namespace {

/// Classes that pluginlib loads, by the parameter that names them.
struct Plugins {
  std::string_view parameter;
  std::vector<std::string_view> names;
};
const std::vector<Plugins>& known_plugins() {
  static const std::vector<Plugins> all = {
      {"kinematics_solver",
       {"kdl_kinematics_plugin/KDLKinematicsPlugin", "lma_kinematics_plugin/LMAKinematicsPlugin",
        "cached_ik_kinematics_plugin/CachedKDLKinematicsPlugin",
        "cached_ik_kinematics_plugin/CachedSrvKinematicsPlugin",
        "srv_kinematics_plugin/SrvKinematicsPlugin",
        "trac_ik_kinematics_plugin/TRAC_IKKinematicsPlugin", "bio_ik/BioIKKinematicsPlugin",
        "pick_ik/PickIkPlugin"}},
      {"moveit_controller_manager",
       {"moveit_simple_controller_manager/MoveItSimpleControllerManager",
        "moveit_fake_controller_manager/MoveItFakeControllerManager",
        "moveit_ros_control_interface/Ros2ControlManager",
        "moveit_ros_control_interface/Ros2ControlMultiManager",
        "moveit_ros_control_interface/MoveItControllerManager",
        "moveit_ros_control_interface/MoveItMultiControllerManager"}},
      {"planning_plugin",
       {"ompl_interface/OMPLPlanner", "chomp_interface/CHOMPPlanner",
        "pilz_industrial_motion_planner/CommandPlanner", "stomp_moveit/StompPlanner",
        "trajopt_interface/TrajOptPlanner"}},
  };
  return all;
}

void check_name(yaml::View value, const std::vector<std::string_view>& known, Findings& findings) {
  const std::string_view name = trimmed(value.text());
  if (name.empty() || is_placeholder(name)) return;
  const auto near = only_nearest(name, known);
  constexpr int kMostEdits = 3;  // others have plugins of their own
  if (!near || edit_distance(*near, name, kMostEdits) > kMostEdits) return;
  Diagnostic& found =
      findings.report(value.span(), "no plugin of MoveIt has the name " + quoted(name));
  found.help("did you mean " + quoted(*near) + "?");
  found.fixes.push_back({Applicability::unsafe, {{value.span(), std::string(*near)}}});
}

// The recursion is as deep as the file, whose depth is limited.
void check_mapping(yaml::View mapping, Findings& findings) {
  for (const yaml::View member : mapping) {
    if (member.is_mapping()) {
      check_mapping(member, findings);
      continue;
    }
    for (const Plugins& plugins : known_plugins()) {
      const bool is_list =
          member.key() == "planning_plugins" && plugins.parameter == "planning_plugin";
      if (member.key() == plugins.parameter && member.is_scalar()) {
        check_name(member, plugins.names, findings);
      } else if (is_list && member.is_sequence()) {
        for (const yaml::View item : member) {
          if (item.is_scalar()) check_name(item, plugins.names, findings);
        }
      }
    }
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for (const Companion& file : companions.files) {
    if (file.kind == CompanionKind::controllers || !file.document) continue;
    const yaml::View root = file.document->view();
    if (root && root.is_mapping()) check_mapping(root, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks,
     "reports that the class does not exist, and goes on without it",
     "moveit2 kinematics_plugin_loader.cpp, planning_pipeline.cpp, trajectory_execution_manager.cpp"},
};

}  // namespace

extern constinit const Rule sml3813_moveit_unknown_plugin{
    .id = "SML3813",
    .name = "moveit-unknown-plugin",
    .severity = Severity::error,
    .summary =
        "A parameter file of MoveIt names a plugin that is nearly, but not quite, a known one.",
    .why = "Plugins of other packages are not known, so only near misses are reported.",
    .remedy = "Correct the name of the class.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3813_moveit_unknown_plugin_file
