// SPDX-License-Identifier: BSD-3-Clause
// The plugins and sensors in the elements `gazebo` of a robot, and questions that several rules
// ask.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "lint/queries.hpp"
#include "readers/gazebo_systems.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// A `plugin` in an element `gazebo`.
struct GazeboPlugin {
  xml::View element, gazebo;
  xml::View sensor;  ///< around it; none outside of sensors
  std::string_view file, name;
  const gazebo::System* system = nullptr;  ///< of gz-sim
};
std::vector<GazeboPlugin> gazebo_plugins(const LinkedModel& model);

/// A `sensor` in an element `gazebo`.
struct WrittenSensor {
  xml::View element, gazebo;
  std::string_view name, type;
};
std::vector<WrittenSensor> gazebo_sensors(const LinkedModel& model);

/// Whether a robot is written for Gazebo, not for Gazebo Classic: it has systems of gz-sim, and no
/// plugin of Gazebo Classic.
bool is_for_gazebo(const LinkedModel& model);

/// The text of an element without the blanks around it, and its place, or that of its name.
std::string_view text_in(xml::View element);
Span place_in(xml::View element);

}  // namespace smurf
