// SPDX-License-Identifier: BSD-3-Clause
// What conversions take from the SRDF of a robot: the pairs of links whose contacts it disables,
// and its group states.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"

namespace smurf {

struct RobotSrdf {
  std::string file;                                     ///< "": none was found
  std::set<std::pair<std::size_t, std::size_t>> pairs;  ///< links, the smaller index first
  /// In the order of the file; states of several groups with one name are one.
  std::vector<std::pair<std::string, JointPositions>> states;
};

/// The SRDF `given`. If it is "": the one beside the URDF, or in srdf/ or config/ there
/// or one folder up, that has the name of the robot, and the name of the URDF file if there are
/// several.
RobotSrdf robot_srdf(const LinkedModel& model, const std::string& given, const FileReader& files,
                     const Limits& limits);

}  // namespace smurf
