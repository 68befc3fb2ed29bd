// SPDX-License-Identifier: BSD-3-Clause
// The files that a result names: copied by --copy-assets, shown by previews.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "common/input.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/flatten.hpp"
#include "smurf/limits.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// A file that is copied to a folder which the user names.
struct AssetCopy {
  std::string from;
  std::string folder;  ///< the user's
  std::string inside;  ///< the path from there

  std::string to() const;
};
using AssetCopies = std::vector<AssetCopy>;

/// Makes the meshes, textures and heightmaps of a scene name copies in `folder`, in a folder a
/// model. Files that do not exist keep their names. Nothing is copied yet.
AssetCopies redirect_assets(FlatScene& flat, const std::string& folder,
                            const FlattenOptions& options, const FileReader& files);

/// Where previews get triangles from; what is a copy is read where it comes from. `files` and
/// `limits` must outlive the result.
MeshSource mesh_source(const FlattenOptions& options, const AssetCopies& copies,
                       const FileReader& files, const Limits& limits);

/// Where copies are made: not where the file itself is already.
std::vector<std::string> places_of(const AssetCopies& copies, const InputFiles& inputs);

/// Copies the files and then calls `write_result`: all or nothing. False when something cannot be
/// written; that has been said. Names come from the model: only files with the name of a mesh or an
/// image are copied, and no other file is replaced unless `overwrite`.
bool copy_files(std::string_view tool, const AssetCopies& copies, const FileReader& files,
                const Limits& limits, bool overwrite, const std::function<bool()>& write_result);

}  // namespace smurf::tools
