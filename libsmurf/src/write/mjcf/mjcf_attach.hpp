// SPDX-License-Identifier: BSD-3-Clause
// The reference form of a MuJoCo world.
#pragma once

#include <string>

#include "smurf/write_scene.hpp"

namespace smurf {

/// A world that attaches the URDFs of the models, which MuJoCo 3.2 and later reads itself.
std::string write_attached(const SceneExport& scene);

}  // namespace smurf
