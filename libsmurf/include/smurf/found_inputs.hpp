// SPDX-License-Identifier: BSD-3-Clause
// Finds the files in a folder that can be checked.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/limits.hpp"

namespace smurf {

/// The result of find_inputs().
struct FoundInputs {
  std::vector<std::string> files;       ///< sorted
  std::vector<std::string> unreadable;  ///< "'robots/old': Permission denied", sorted
  std::size_t left_out = 0;             ///< files and folders
  std::size_t links_outside = 0;        ///< links that lead out of the folder
  /// Links with the name of a model that lead out of the folder, perhaps to elsewhere in its
  /// project; sorted.
  std::vector<std::string> model_links{};
  std::vector<std::string> xacro;  ///< .xacro files, sorted
  std::vector<std::string> xml;    ///< files that may be MJCF or SDF, sorted
  std::vector<std::string> yaml;   ///< files that may be companions, sorted
};

/// Whether a path inside a searched folder is skipped, with all its contents.
using LeftOut = std::function<bool(const std::string& path, bool is_folder)>;

/// Finds the .smurf, .smurfs, .smurfa and .urdf files in a folder and its subfolders, each once,
/// and those that may be others. Skips hidden files, and links that lead out of the folder.
FoundInputs find_inputs(const std::string& folder, const Limits& limits,
                        const LeftOut& is_left_out = nullptr);

/// Whether a file may be MJCF or SDF, by its name; many XML files are something else.
bool may_be_imported(std::string_view path);
/// Whether a text is a robot or a world in one of them, by its root element.
bool is_imported(std::string_view text);

/// The name of a robot that standard input holds, as its root element asks for: "stdin.urdf",
/// ".urdf.xacro", ".xml" (MJCF) or ".sdf". "" for a text that is no XML.
std::string standard_input_name(std::string_view text);

/// "no .smurf, .smurfs, .smurfa, .urdf or .xacro file in 'robots' (2 left out)",
/// and a note on others.
std::string why_nothing(const FoundInputs& found, const std::string& folder);

}  // namespace smurf
