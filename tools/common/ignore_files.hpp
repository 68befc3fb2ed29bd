// SPDX-License-Identifier: BSD-3-Clause
// What .gitignore and .smurf-lintignore files leave out.
#pragma once

#include <map>
#include <string>

#include "base/path_patterns.hpp"
#include "smurf/file_reader.hpp"

namespace smurf::tools {

/// The ignore files of all folders that are asked about, each read once. As in git, the nearest
/// file with an opinion wins, and .gitignore counts inside a repository only; .smurf-lintignore
/// counts everywhere, and more.
class IgnoreFiles {
 public:
  explicit IgnoreFiles(const FileReader& files) : files_(files) {}

  /// Of the path alone, without what is said of the folders above it. `path` is absolute.
  bool leaves_out(const std::string& path, bool is_folder);
  /// Is a file left out, itself or with a folder that it lies in?
  bool leaves_out_with_folders(const std::string& path);

 private:
  struct Level {
    std::string folder;
    const Level* above = nullptr;
    PathPatterns of_git, of_lint;
    bool is_in_repository = false;
    bool is_repository = false;  ///< its top: ignore files above are another repository's
  };
  const Level& level_of(const std::string& folder);

  const FileReader& files_;
  std::map<std::string, Level> levels_;
};

}  // namespace smurf::tools
