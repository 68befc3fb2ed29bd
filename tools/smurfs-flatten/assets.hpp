// SPDX-License-Identifier: BSD-3-Clause
// The files that a result names, copied by --copy-assets.
#pragma once

#include <string>
#include <string_view>

#include "common/asset_copies.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"

namespace smurf::tools {

/// Changes the names of the meshes, textures and heightmaps of a scene to copies in `folder`, with
/// one subfolder per model. Files that do not exist keep their names. Nothing is copied yet.
AssetCopies redirect_assets(FlatScene& flat, const std::string& folder,
                            const FlattenOptions& options, const FileReader& files,
                            const Limits& limits);

/// The copies that a result names, and the files that these need. `text` is the result; names are
/// sought as they are written in XML. Previews contain their meshes, so they name no files.
AssetCopies named_copies(const AssetCopies& copies, std::string_view text,
                         const FlattenOptions& options);

}  // namespace smurf::tools
