// SPDX-License-Identifier: BSD-3-Clause
// What several rules ask of a controller of trajectories.
#pragma once

#include <set>
#include <string_view>

#include "lint/companions/controllers.hpp"

namespace smurf {

/// Whether it is a joint_trajectory_controller of ros2_controllers.
bool is_trajectory_controller(const RosController& controller);

/// The texts of a list without repetitions.
std::set<std::string_view> names_in(const RosController& controller, std::string_view key);

/// Why these command interfaces cannot be used together; "" if they can.
std::string_view why_not_together(const std::set<std::string_view>& commands);

}  // namespace smurf
