// SPDX-License-Identifier: BSD-3-Clause
// Copies of meshes in OBJ, for programs that do not read the format of the original.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"
#include "smurf/new_model.hpp"
#include "smurf/readers.hpp"

namespace smurf {

struct MeshCopies {
  std::vector<TextFile> files;               ///< in the folder of the copies
  std::map<std::string, std::string> names;  ///< those of the copies, by MeshReference::path
};

/// Copies the meshes of a model that the reader does not read, and that can be read here. Colours
/// of the parts of a mesh become a material file.
MeshCopies copies_for(const Reader& reader, const LinkedModel& model, const FileReader& files,
                      const Limits& limits);

}  // namespace smurf
