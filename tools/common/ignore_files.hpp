// SPDX-License-Identifier: BSD-3-Clause
// What .gitignore and .smurf-lintignore files leave out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "base/path_patterns.hpp"
#include "smurf/file_reader.hpp"

namespace smurf::tools {

/// The ignore files of all folders that are asked about, each read once. As in git, the nearest
/// file with a matching pattern wins, and .gitignore applies inside a repository only;
/// .smurf-lintignore applies everywhere, and takes precedence.
class IgnoreFiles {
 public:
  /// `most_checks` is how often a path is compared with a pattern.
  IgnoreFiles(const FileReader& files, std::uint64_t most_checks)
      : files_(files), checks_left_(most_checks) {}

  /// Have there been more checks than that? Then everything is left out.
  bool is_exhausted() const { return is_exhausted_; }
  /// Checks of patterns that are not in ignore files are of the same number. False when they are
  /// too many.
  bool may_check(std::size_t patterns);
  /// The verdict of the patterns on a path; a slow comparison counts as several checks.
  PathVerdict judge(const PathPatterns& patterns, std::string_view path, bool is_folder);
  /// Do they exclude a file, itself or with a folder that it lies in?
  bool excludes(const PathPatterns& patterns, std::string_view file);

  /// The verdict on the path alone, without the folders above it. `path` is absolute, unless the
  /// current folder has no path that can be told.
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
  void count(std::uint64_t steps);
  const Level& level_of(const std::string& folder);

  const FileReader& files_;
  std::uint64_t checks_left_;
  bool is_exhausted_ = false;
  std::map<std::string, Level> levels_;
};

}  // namespace smurf::tools
