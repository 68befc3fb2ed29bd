// SPDX-License-Identifier: BSD-3-Clause
// Drawings (.svg) as scenes.
#pragma once

#include <string>

#include "smurf/load.hpp"

namespace smurf {

bool is_drawing(std::string_view path);

/// Reads the drawing of `file`, whose path and source are known, and the YAML files that its titles
/// name. `file.document` becomes the scene that they mean together, `file.drawing` what is drawn;
/// the YAML files are added to `data_files`, since the scene is a view into them. False when
/// something is missing or broken, which was reported.
bool read_drawn_scene(SceneFile& file, std::vector<DataFile>& data_files, LoadContext& context);

}  // namespace smurf
