// SPDX-License-Identifier: BSD-3-Clause
// The robots that a file of ROS is about, for editors in which no robot is open.
#pragma once

#include <string>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// Those that a launch file or a .setup_assistant gives the file to; of a launch file, those that
/// it starts. Else the likeliest of its project, see CompanionRobots. Empty for a file that is no
/// launch file, no parameter file of ROS and no configuration of RViz.
std::vector<std::string> robots_around(const std::string& path, const FileReader& files,
                                       const Limits& limits);

}  // namespace smurf
