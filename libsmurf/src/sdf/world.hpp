// SPDX-License-Identifier: BSD-3-Clause
// A world as a scene of SMURF: its models are entities, and its lights and its gravity stay.
#pragma once

#include "sdf/model.hpp"
#include "sdf/sdf.hpp"

namespace smurf::sdformat {

/// Adds the text of the scene, and those of its models, to the sources.
void write_world(Model& model, Files& files, Reporter& reporter, World& result);

}  // namespace smurf::sdformat
