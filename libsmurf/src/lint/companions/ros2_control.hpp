// SPDX-License-Identifier: BSD-3-Clause
// The elements `ros2_control` of a robot, and questions that several rules ask about them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// `command_interface` or `state_interface`.
struct HardwareInterface {
  xml::View element;
  bool is_command = false;
  std::string_view name;  ///< empty if it is missing

  /// The text of `<param name="...">`; none if it is not written.
  std::optional<std::string_view> parameter(std::string_view wanted) const;
  xml::View parameter_element(std::string_view wanted) const;
};

/// `joint`, `sensor` or `gpio`.
struct HardwarePart {
  xml::View element;
  std::string_view name;
  std::vector<HardwareInterface> interfaces;

  bool is_joint() const { return element.name() == "joint"; }
  bool has_command() const;
  bool has(std::string_view interface, bool is_command) const;
};

/// One element `ros2_control`.
struct Hardware {
  xml::View element;
  std::string_view name, type;
  std::vector<HardwarePart> parts;

  const HardwarePart* find_joint(std::string_view wanted) const;
};

/// In the order of the file.
std::vector<Hardware> hardware_of(const LinkedModel& model);

/// The text of an attribute without the blanks around it; empty if it is missing.
std::string_view attribute_text(xml::View element, std::string_view name);
/// The value of an attribute, or the name of the element if it is missing.
Span place_of(xml::View element, std::string_view attribute);
/// "ros2_control `arm`".
std::string title_of(const Hardware& hardware);
/// "joint `elbow` of ros2_control `arm`"
std::string title_of(const HardwarePart& part, const Hardware& hardware);

/// SML3601: the hardware has no plugin at all; that of a xacro file may need an argument.
inline constexpr Circumstance kNoPlugin{"no plugin"};
/// SML3613: the robot lacks the plugin of Gazebo, or the name of its file.
inline constexpr Circumstance kNoSimulation{"no simulation"};

/// The first version with the parser of Jazzy, for facts about ros2_control and about ROS.
inline constexpr Version kParserOfJazzy{4};
inline constexpr Version kRosJazzy{2024};

/// An exception of the parser: no hardware of the robot is loaded.
constexpr Fact
no_hardware(Where where = {},
            std::string_view makes = "throws an exception and loads no hardware at all") {
  return {&readers::ros2_control, Effect::refuses, makes,
          "ros2_control hardware_interface/src/component_parser.cpp", where};
}
constexpr Fact no_hardware_in_ros(Where where = {}) {
  return {&readers::ros, Effect::breaks, "ros2_control loads no hardware",
          "ros2_control hardware_interface/src/component_parser.cpp", where};
}

/// What Humble does with a mistake that later versions refuse.
constexpr Fact in_humble(Effect effect, std::string_view makes, Where where = {}) {
  where.until = kParserOfJazzy;
  return {&readers::ros2_control, effect, makes,
          "ros2_control hardware_interface/src/component_parser.cpp, branch humble", where};
}
constexpr Fact in_ros_humble(Effect effect, std::string_view makes, Where where = {}) {
  where.until = kRosJazzy;
  return {&readers::ros, effect, makes,
          "ros2_control hardware_interface/src/component_parser.cpp, branch humble", where};
}

}  // namespace smurf
