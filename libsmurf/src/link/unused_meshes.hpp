// SPDX-License-Identifier: BSD-3-Clause
// Mesh files beside those of a robot.
#pragma once

#include "smurf/load.hpp"

namespace smurf {

/// Fills in LinkedModel::unused_meshes: those in the folders of the meshes of the robot whose names
/// no text of its package has. None if the robot computes such names, if the package has other
/// robots, or if a mesh is missing, because an unused file may be that mesh. `context` has read the
/// robot.
void find_unused_meshes(LinkedModel& model, const LoadContext& context);

}  // namespace smurf
