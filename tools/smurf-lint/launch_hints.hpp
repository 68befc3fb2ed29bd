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

/// Looks for the names of the robots in the launch files of a folder. Nothing is run: an argument
/// gets its values from a literal `name:=value`, or from the choices or the default of the launch
/// argument of the same name. Arguments whose own default is one of the choices are left out.
std::vector<LaunchedRobot> launched_robots(const std::string& folder,
                                           const std::vector<std::string>& robots,
                                           const Limits& limits);

}  // namespace smurf::tools
