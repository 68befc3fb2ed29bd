// SPDX-License-Identifier: BSD-3-Clause
// Reads the launch files and build files around a robot.
#pragma once

#include "smurf/companions.hpp"

namespace smurf {

/// Adds those of the package of a robot, and the launch files that name it in packages that depend
/// on that one. Gives meshes their places in the sources of packages that install them elsewhere.
void add_surroundings(Accompanied& robot, LoadContext& context);

}  // namespace smurf
