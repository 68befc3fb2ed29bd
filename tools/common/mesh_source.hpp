// SPDX-License-Identifier: BSD-3-Clause
// Reads meshes and textures for formats that show them.
#pragma once

#include <string>

#include "common/asset_copies.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// The path of a file for `files`; in an archive, it begins with the path of the archive.
std::string known_name(const std::string& absolute, const std::string& current,
                       const FileReader& files);

/// Reads triangles and images. A file that will be copied is read from its original. `files` and
/// `limits` must outlive the result.
MeshSource mesh_source(const FlattenOptions& options, const AssetCopies& copies,
                       const FileReader& files, const Limits& limits);

}  // namespace smurf::tools
