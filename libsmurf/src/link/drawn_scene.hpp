// SPDX-License-Identifier: BSD-3-Clause
// Drawings (.svg) as scenes.
#pragma once

#include <string>

#include "smurf/load.hpp"

namespace smurf {

bool is_drawing(std::string_view path);

/// Reads the drawing of `file`, whose path and source are known, and the YAML files that its titles
/// name. Sets `file.document` to the resulting scene and `file.drawing` to the drawing. The YAML
/// files are added to `data_files`, because the scene refers to them. Reports missing and broken
/// files and returns false.
bool read_drawn_scene(SceneFile& file, std::vector<DataFile>& data_files, LoadContext& context);

}  // namespace smurf
