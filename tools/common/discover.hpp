// SPDX-License-Identifier: BSD-3-Clause
// Which files a folder holds, and which models a file belongs to.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "smurf/file_reader.hpp"

namespace smurf::tools {

struct Found {
  std::vector<std::string> files;       ///< sorted
  std::vector<std::string> unreadable;  ///< "'robots/old': Permission denied", sorted
  std::size_t left_out = 0;             ///< files and folders
};

/// Says of a path inside a folder that is searched whether it is left out, with all that is in it.
using LeftOut = std::function<bool(const std::string& path, bool is_folder)>;

/// The .smurf, .smurfs, .smurfa and .urdf files in a folder and the folders below it. Hidden ones
/// are left out; links are followed, but nothing is found twice.
Found find_inputs(const std::string& folder, const LeftOut& is_left_out = nullptr);

// Both know nothing of files that are too large to be looked at on the way (docs/limits.md).

/// The .smurf files that list a file, sought in its folder, the folder above, and the `smurf`
/// folders in both; sorted.
std::vector<std::string> models_listing(const std::string& path, const FileReader& files);

/// The .smurf files, and the .urdf files that none of them lists, whose meshes or textures include
/// a file; sought in the three folders above it and the `smurf` and `urdf` folders there; sorted.
std::vector<std::string> models_using(const std::string& path, const FileReader& files);

}  // namespace smurf::tools
