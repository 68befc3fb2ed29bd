// SPDX-License-Identifier: BSD-3-Clause
// What conversions take from the SRDF of a robot: the pairs of links whose contacts it disables,
// and its group states.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>

#include "conversion/own_companions.hpp"
#include "smurf/linked.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

struct RobotSrdf {
  std::string file;                                     ///< "": none was found
  std::set<std::pair<std::size_t, std::size_t>> pairs;  ///< links, the smaller index first
  NamedPositions states;  ///< in the order of the file; states of several groups with one name are
                          ///< one
};

/// The SRDF `given`. If it is "": that which belongs to the robot with the strongest evidence, has
/// its name or is tied to it, and the name of the URDF file if there are several.
RobotSrdf robot_srdf(const LinkedModel& model, const std::string& given, OwnCompanions& companions);

}  // namespace smurf
