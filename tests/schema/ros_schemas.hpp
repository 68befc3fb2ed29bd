// SPDX-License-Identifier: BSD-3-Clause
// The schemas of the parameter files of ROS, from the tables of src/ast/ros_parameters.hpp.
#pragma once

#include <map>
#include <string>

#include "schema/schema_head.hpp"

namespace smurf::test {

/// "moveit-kinematics" -> its schema.
std::map<std::string, Json> ros_schemas();

}  // namespace smurf::test
