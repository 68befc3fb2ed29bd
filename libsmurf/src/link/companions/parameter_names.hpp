// SPDX-License-Identifier: BSD-3-Clause
// Names in parameter files of ROS.
#pragma once

#include "smurf/companions.hpp"

namespace smurf {

class ReferenceFinder;

/// Adds the names of joints, links and groups in a companion that is YAML.
void add_parameter_names(const Companion& companion, ReferenceFinder& finder);

}  // namespace smurf
