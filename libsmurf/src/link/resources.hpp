// SPDX-License-Identifier: BSD-3-Clause
// Meshes and textures a model names, and the files they mean.
#pragma once

#include "smurf/load.hpp"

namespace smurf {

/// Fills in the meshes of the URDF, if there is one, and the textures of the annotations; opens
/// the meshes when the context has a library for them.
void resolve_resources(LinkedModel& model, const LoadContext& context);

}  // namespace smurf
