// SPDX-License-Identifier: BSD-3-Clause
// Data for the pages of web/viewer. web/viewer/scene.js reads it and documents its members.
#pragma once

#include <optional>
#include <string>

#include "smurf/write_scene.hpp"

namespace smurf {

/// The scene as JSON, followed by an old version of it unless `before` is null; none if it is too
/// large. Meshes come from `scene`, and must have the same names in both.
std::optional<std::string> viewer_data(const SceneExport& scene, const SceneExport* before);

}  // namespace smurf
