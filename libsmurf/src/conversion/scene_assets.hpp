// SPDX-License-Identifier: BSD-3-Clause
// The files that a result names, copied by --copy-assets.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "smurf/asset_copies.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"

namespace smurf {

/// Changes the names of the meshes, textures and heightmaps of a scene to copies in `folder`, with
/// one subfolder per model. Files that do not exist, or that stay (relative to the output folder),
/// keep their names. Nothing is copied yet.
AssetCopies redirect_assets(FlatScene& flat, const std::string& folder,
                            const FlattenOptions& options, const FileReader& files,
                            const Limits& limits,
                            const std::function<bool(const std::string& file)>& stays);

/// The copies that the result `text` refers to, and the files that these copies need. Paths are
/// compared as XML escapes them. Previews contain their meshes and refer to no files.
AssetCopies named_copies(const AssetCopies& copies, std::string_view text,
                         const FlattenOptions& options);

}  // namespace smurf
