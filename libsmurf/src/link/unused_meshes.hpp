// SPDX-License-Identifier: BSD-3-Clause
// Mesh files beside those of a robot.
#pragma once

#include "smurf/load.hpp"

namespace smurf {

/// Fills in LinkedModel::unused_meshes with the mesh files that lie beside meshes of the robot, and
/// that no text in its package names. There are none if the robot computes such names, if the
/// package has other robots, or if a mesh is missing, because an unused file may be that mesh.
/// `context` has read the robot.
void find_unused_meshes(LinkedModel& model, const LoadContext& context);

}  // namespace smurf
