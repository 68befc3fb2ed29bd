// SPDX-License-Identifier: BSD-3-Clause
// Values in launch files for the arguments of a robot that have none.
#pragma once

#include <string>

#include "smurf/load.hpp"

namespace smurf {

/// Adds values to the arguments of the context if the file cannot be expanded without them, and
/// launch files, tests or CMake in its package give them. Returns what was added and from where:
/// "`model:=mk3`, from `launch/d.launch.py`"; "" if nothing was.
std::string add_launched_values(const std::string& path, LoadContext& context);

}  // namespace smurf
