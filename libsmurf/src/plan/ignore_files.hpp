// SPDX-License-Identifier: BSD-3-Clause
// Reads .gitignore and .smurf-lintignore files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "base/files/path_patterns.hpp"
#include "smurf/file_reader.hpp"

namespace smurf {

/// Reads the ignore files of each folder once, as long as it does not meet thousands of others. As
/// in git, the nearest file with a matching pattern applies, and .gitignore only applies inside a
/// repository; .smurf-lintignore applies everywhere, and takes precedence.
class IgnoreFiles {
 public:
  /// `most_checks` limits how often a path is compared with a pattern.
  IgnoreFiles(const FileReader& files, std::uint64_t most_checks)
      : files_(files), checks_left_(most_checks) {}

  /// True after more checks than that; then all files are left out.
  bool is_exhausted() const { return is_exhausted_; }
  /// Counts checks of other patterns within the same limit. False if there are too many.
  bool may_check(std::size_t patterns);
  /// The verdict of the patterns on a path; a slow comparison counts as several checks.
  PathVerdict judge(const PathPatterns& patterns, std::string_view path, bool is_folder);
  /// Whether the patterns exclude a file, or a folder that contains it.
  bool excludes(const PathPatterns& patterns, std::string_view file);

  /// The verdict on the path alone, without the folders above it. `path` is absolute unless the
  /// path of the current folder is unknown.
  bool leaves_out(const std::string& path, bool is_folder);
  /// Whether a file, or a folder that contains it, is left out. A .gitignore above the innermost
  /// repository does not count.
  bool leaves_out_with_folders(const std::string& path);

 private:
  struct Level {
    std::string folder;
    const Level* above = nullptr;
    PathPatterns of_git, of_lint;
    bool is_in_repository = false;
    bool is_repository = false;  ///< ignore files above a repository do not apply
  };
  void count(std::uint64_t steps);
  PathVerdict lint_verdict(const std::string& path, bool is_folder);
  const Level& level_of(const std::string& folder);
  /// The level of the folder of a path, which is valid until the next call.
  const Level& level_around(const std::string& path);

  const FileReader& files_;
  std::uint64_t checks_left_;
  bool is_exhausted_ = false;
  std::map<std::string, Level> levels_;
};

}  // namespace smurf
