// SPDX-License-Identifier: BSD-3-Clause
// The lights of a stage in UsdLux.
#pragma once

#include <string>

#include "smurf/write_scene.hpp"
#include "write/usd/usda_text.hpp"

namespace smurf {

/// A scope of this name with all lights of the world; nothing if there are none.
void add_usd_lights(const SceneExport& scene, const std::string& scope, UsdaText& text);

}  // namespace smurf
