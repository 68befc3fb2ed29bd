// SPDX-License-Identifier: BSD-3-Clause
// Values of xacro arguments that launch files mention, for the configuration that --init writes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "smurf/limits.hpp"

namespace smurf::tools {

/// A robot of xacro, and values of those of its arguments that need one.
struct LaunchedRobot {
  std::string file;
  std::vector<std::pair<std::string, std::vector<std::string>>> arguments;
};

/// Nothing is run. An argument gets the choices of the launch argument of its name, unless its
/// own default is one of them, and what a check uses where the robot cannot be expanded otherwise.
/// A robot that cannot be expanded with these is left out.
std::vector<LaunchedRobot> launched_robots(const std::string& folder,
                                           const std::vector<std::string>& robots,
                                           const Limits& limits);

}  // namespace smurf::tools
