// SPDX-License-Identifier: BSD-3-Clause
// Meshes and textures a URDF names, and the files they mean.
#pragma once

#include <vector>

#include "smurf/load.hpp"

namespace smurf {

/// Every mesh and texture of the robot, in document order. Precondition: model.robot is set.
std::vector<MeshReference> resolve_resources(const LinkedModel& model, const LoadContext& context);

}  // namespace smurf
