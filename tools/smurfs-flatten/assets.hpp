// SPDX-License-Identifier: BSD-3-Clause
// The files that a result names: copied by --copy-assets, shown by previews.
#pragma once

#include <string>

#include "common/asset_copies.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// Makes the meshes, textures and heightmaps of a scene name copies in `folder`, in a folder a
/// model. Files that do not exist keep their names. Nothing is copied yet.
AssetCopies redirect_assets(FlatScene& flat, const std::string& folder,
                            const FlattenOptions& options, const FileReader& files);

/// Where previews get triangles from; what is a copy is read where it comes from. `files` and
/// `limits` must outlive the result.
MeshSource mesh_source(const FlattenOptions& options, const AssetCopies& copies,
                       const FileReader& files, const Limits& limits);

}  // namespace smurf::tools
