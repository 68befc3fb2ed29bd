// SPDX-License-Identifier: BSD-3-Clause
// The meshes and textures that a model names, and their files.
#pragma once

#include "smurf/load.hpp"

namespace smurf {

/// Finds the meshes of the URDF, if there is one, and the textures of the annotations; opens the
/// meshes if the context has a mesh library.
void resolve_resources(LinkedModel& model, LoadContext& context);

}  // namespace smurf
