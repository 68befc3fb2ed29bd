// SPDX-License-Identifier: BSD-3-Clause
// Finds the files in a folder that can be checked.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/limits.hpp"

namespace smurf::tools {

struct Found {
  std::vector<std::string> files;       ///< sorted
  std::vector<std::string> unreadable;  ///< "'robots/old': Permission denied", sorted
  std::size_t left_out = 0;             ///< files and folders
  std::size_t xacro = 0;                ///< .xacro files, which have to be expanded first
};

/// Decides whether a path inside a searched folder is left out, with everything in it.
using LeftOut = std::function<bool(const std::string& path, bool is_folder)>;

bool is_xacro_file(std::string_view path);

/// Finds the .smurf, .smurfs, .smurfa and .urdf files in a folder and the folders below it, each
/// once. Leaves out hidden files, and links that lead out of the folder.
Found find_inputs(const std::string& folder, const Limits& limits,
                  const LeftOut& is_left_out = nullptr);

/// "no .smurf, .smurfs, .smurfa or .urdf file in 'robots' (2 left out)", and what else is there.
std::string why_nothing(const Found& found, const std::string& folder);

}  // namespace smurf::tools
