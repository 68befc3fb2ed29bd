// SPDX-License-Identifier: BSD-3-Clause
// Source: ros2_controllers validate_jtc_parameters.hpp.
#include "lint/companions/trajectory.hpp"

namespace smurf {

bool is_trajectory_controller(const RosController& controller) {
  return controller.known != nullptr &&
         controller.known->name == "joint_trajectory_controller/JointTrajectoryController";
}

std::set<std::string_view> names_in(const RosController& controller, std::string_view key) {
  std::set<std::string_view> names;
  for (const yaml::View item : controller.list(key)) names.insert(item.text());
  return names;
}

std::string_view why_not_together(const std::set<std::string_view>& commands) {
  const bool has_position = commands.contains("position");
  const bool has_velocity = commands.contains("velocity");
  if (has_velocity && commands.size() > 1 && !has_position) {
    return "`velocity` must be alone or with `position`";
  }
  if (commands.contains("acceleration") && !has_velocity && !has_position) {
    return "`acceleration` needs `position` and `velocity`";
  }
  const bool is_small = commands.size() == 1 || (commands.size() == 2 && has_position);
  if (commands.contains("effort") && !is_small) {
    return "`effort` must be alone or, from Jazzy on, with `position`";
  }
  return {};
}

}  // namespace smurf
