// SPDX-License-Identifier: BSD-3-Clause
// What the pages of web/viewer show. web/viewer/scene.js, which reads it, documents its members.
#pragma once

#include <optional>
#include <string>

#include "smurf/write_scene.hpp"

namespace smurf {

/// The scene as JSON, followed by an old version of it unless `before` is null; none when it is
/// too large. Meshes come from `scene`, and must have the same names in both.
std::optional<std::string> viewer_data(const SceneExport& scene, const SceneExport* before);

}  // namespace smurf
