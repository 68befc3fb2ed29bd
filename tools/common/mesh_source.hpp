// SPDX-License-Identifier: BSD-3-Clause
// The meshes of previews.
#pragma once

#include <string>

#include "common/asset_copies.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// Files of an archive go by the name that the archive was given.
std::string known_name(const std::string& absolute, const std::string& current,
                       const FileReader& files);

/// Where previews get triangles from; what is a copy is read where it comes from. `files` and
/// `limits` must outlive the result.
MeshSource mesh_source(const FlattenOptions& options, const AssetCopies& copies,
                       const FileReader& files, const Limits& limits);

}  // namespace smurf::tools
