// SPDX-License-Identifier: BSD-3-Clause
// The <sensor> elements in <gazebo>, and poses of sensors.
#pragma once

#include <string_view>
#include <vector>

#include "smurf/pose.hpp"
#include "smurf/urdf.hpp"
#include "smurf/xml.hpp"

namespace smurf {

struct GazeboSensor {
  xml::View element;
  std::string_view reference;  ///< the `reference` of the <gazebo> around it
};

std::vector<GazeboSensor> gazebo_sensors(const urdf::Robot& robot);

/// The pose of a sensor of Gazebo, or of an old URDF, on its link: from <pose>x y z r p y</pose> or
/// <origin xyz="" rpy=""/>; absent or unreadable numbers are 0.
Pose sensor_pose(xml::View sensor);

}  // namespace smurf
