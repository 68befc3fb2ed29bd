// SPDX-License-Identifier: BSD-3-Clause
// How a transmission, or a joint of ros2_control, commands its joint.
#pragma once

#include <optional>
#include <string_view>

#include "smurf/xml.hpp"

namespace smurf {

/// The command of a joint of ros2_control.
struct JointCommand {
  xml::View element;           ///< <command_interface>
  std::string_view interface;  ///< "position", "velocity" or "effort"
  std::optional<double> position_lower, position_upper;
  std::optional<double> speed, effort;  ///< largest values
};
/// A joint that can be commanded in several ways has the position, else the velocity, else the
/// effort; but the `preferred` interface, if it has it. None if it is only observed.
std::optional<JointCommand> joint_command(xml::View joint, std::string_view preferred = {});

/// The interface of a transmission, "" if it states none, such as
/// "hardware_interface/EffortJointInterface". None if the joint is only observed.
std::optional<std::string_view> transmission_interface(xml::View transmission);

}  // namespace smurf
