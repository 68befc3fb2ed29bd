// SPDX-License-Identifier: BSD-3-Clause
// What the files of a robot say to the launch files that expand them.
#pragma once

#include "smurf/load.hpp"
#include "smurf/surroundings.hpp"

namespace smurf {

/// Fills in the arguments, what breaks YAML, and the calls about which xacro warns.
void read_robot_facts(const LinkedModel& model, const LoadContext& context, Surroundings& found);

}  // namespace smurf
