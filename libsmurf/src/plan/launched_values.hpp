// SPDX-License-Identifier: BSD-3-Clause
// Values in launch files for the arguments of a robot that have none.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "smurf/load.hpp"
#include "xacro/seen_arguments.hpp"

namespace smurf {

/// The values without which the file cannot be expanded: those that launch files give to this
/// robot; else those that launch files, tests or CMake in its package give to an argument of the
/// name; else the default that the file declares below the first use, where xacro does not know it
/// yet. Empty if the file needs none, or if arguments remain without a value.
std::vector<xacro::SeenArgument> launched_values(const std::string& path, LoadContext& context);
std::vector<xacro::SeenArgument>
launched_values(const std::string& path, const std::map<std::string, std::string>& arguments,
                const FileReader& files, const Limits& limits);

/// Reports each of these values that is a default of the robot itself, and stands below the use
/// that needs it: xacro stops there, unless somebody gives a value.
void report_late_defaults(const std::string& path, const std::vector<xacro::SeenArgument>& values,
                          LoadContext& context);

/// Whether a xacro file can be expanded with these arguments.
bool is_expandable(const std::string& path, const std::map<std::string, std::string>& arguments,
                   const FileReader& files, const Limits& limits);

/// "`model:=mk3`, from `launch/d.launch.py`"
std::string describe(const std::vector<xacro::SeenArgument>& values);

}  // namespace smurf
