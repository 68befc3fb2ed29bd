// SPDX-License-Identifier: BSD-3-Clause
// The kinds of companions. A new kind is a row here, its names in parameter_names.cpp, and rules.
#include <algorithm>
#include <array>

#include "base/files/path.hpp"
#include "smurf/companions.hpp"
#include "smurf/source.hpp"

namespace smurf {
namespace {

/// Whether a text has a part outside of comments.
bool holds(std::string_view text, std::string_view part) {
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at)) {
    const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
    if (text.substr(line, at - line).find('#') == std::string_view::npos) return true;
    at = text.find('\n', at);
    if (at == std::string_view::npos) break;
  }
  return false;
}

bool is_srdf(std::string_view name, std::string_view) { return is_companion_path(name); }

bool is_controllers(std::string_view, std::string_view text) {
  return holds(text, "ros__parameters:") &&
         (holds(text, "controller_manager:") || holds(text, "command_interfaces:"));
}

bool is_joint_limits(std::string_view, std::string_view text) {
  // Values with a tag, such as `!degrees`, are for xacro.
  return holds(text, "joint_limits:") && !holds(text, ": !") &&
         (holds(text, "has_velocity_limits:") || holds(text, "has_acceleration_limits:"));
}

bool is_kinematics(std::string_view, std::string_view text) {
  return holds(text, "kinematics_solver:");
}

bool is_moveit_controllers(std::string_view, std::string_view text) {
  // In ROS 1, controllers are in a list, those of the simulation also without an action.
  const bool has_manager =
      holds(text, "controller_names:") || holds(text, "moveit_simple_controller_manager:");
  const bool has_controllers =
      holds(text, "action_ns:") || (holds(text, "type:") && holds(text, "joints:"));
  return (has_manager && has_controllers) ||
         (holds(text, "controller_list:") && holds(text, "joints:")) ||
         (holds(text, "/JointTrajectoryController") && holds(text, "joints:") &&
          !holds(text, "ros__parameters:"));
}

bool is_ompl_planning(std::string_view, std::string_view text) {
  return holds(text, "planner_configs:");
}

bool is_sensors_3d(std::string_view, std::string_view text) {
  return holds(text, "sensors:") && holds(text, "sensor_plugin:");
}

bool is_setup_assistant(std::string_view name, std::string_view text) {
  return name == ".setup_assistant" && holds(text, "moveit_setup_assistant_config:");
}

constexpr std::array kKinds = {
    CompanionSpec{CompanionKind::srdf, "SRDF", true, is_srdf},
    CompanionSpec{CompanionKind::controllers, "controllers.yaml", false, is_controllers},
    CompanionSpec{CompanionKind::joint_limits, "joint_limits.yaml", false, is_joint_limits},
    CompanionSpec{CompanionKind::kinematics, "kinematics.yaml", false, is_kinematics},
    CompanionSpec{CompanionKind::moveit_controllers, "moveit_controllers.yaml", false,
                  is_moveit_controllers},
    CompanionSpec{CompanionKind::ompl_planning, "ompl_planning.yaml", false, is_ompl_planning},
    CompanionSpec{CompanionKind::sensors_3d, "sensors_3d.yaml", false, is_sensors_3d},
    CompanionSpec{CompanionKind::setup_assistant, ".setup_assistant", false, is_setup_assistant},
};

bool is_yaml(std::string_view path) {
  const std::string extension = path::to_lower(path::extension(path));
  return extension == ".yaml" || extension == ".yml" || path::file_name(path) == ".setup_assistant";
}

}  // namespace

std::span<const CompanionSpec> companion_kinds() { return kKinds; }

const CompanionSpec& spec_of(CompanionKind kind) {
  return *std::find_if(kKinds.begin(), kKinds.end(),
                       [&](const CompanionSpec& one) { return one.kind == kind; });
}

const CompanionSpec* find_companion_kind(std::string_view path, std::string_view text) {
  const bool may_be_yaml = is_yaml(path);
  for (const CompanionSpec& one : kKinds) {
    if (!one.is_xml && !may_be_yaml) continue;
    if (one.is_one(path::file_name(path), text)) return &one;
  }
  return nullptr;
}

}  // namespace smurf
