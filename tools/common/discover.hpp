// SPDX-License-Identifier: BSD-3-Clause
// Finds the files in a folder that can be checked.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/check.hpp"
#include "smurf/limits.hpp"

namespace smurf::tools {

struct Found {
  std::vector<std::string> files;       ///< sorted
  std::vector<std::string> unreadable;  ///< "'robots/old': Permission denied", sorted
  std::size_t left_out = 0;             ///< files and folders
  std::size_t links_outside = 0;        ///< links that lead out of the folder
  std::vector<std::string> xacro;       ///< .xacro files, sorted
};

/// Whether a path inside a searched folder is skipped, with all its contents.
using LeftOut = std::function<bool(const std::string& path, bool is_folder)>;

/// Finds the .smurf, .smurfs, .smurfa and .urdf files in a folder and its subfolders, each once.
/// Skips hidden files, and links that lead out of the folder.
Found find_inputs(const std::string& folder, const Limits& limits,
                  const LeftOut& is_left_out = nullptr);

/// "no .smurf, .smurfs, .smurfa or .urdf file in 'robots' (2 left out)", and a note on others.
std::string why_nothing(const Found& found, const std::string& folder);

/// The only file of a kind in a folder, for the first of these kinds that occurs. Reports an error
/// and returns none if there are several files of that kind, or no file of any kind.
std::optional<std::string> find_only_input(std::string_view tool, const std::string& folder,
                                           std::span<const InputKind> kinds, const Limits& limits);

}  // namespace smurf::tools
