// SPDX-License-Identifier: BSD-3-Clause
// The pose of a sensor of Gazebo, or of an old URDF, on its link.
#pragma once

#include "smurf/pose.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// From <pose>x y z r p y</pose> or <origin xyz="" rpy=""/>; absent or unreadable numbers are 0.
Pose sensor_pose(xml::View sensor);

}  // namespace smurf
