// SPDX-License-Identifier: BSD-3-Clause
// Patterns of paths with the meaning that .gitignore gives them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace smurf {

/// The verdict of patterns on a path.
enum class PathVerdict : std::uint8_t { unmentioned, excluded, included };

/// Paths are relative to the folder of the patterns. `*`, `?` and `[a-z]` match within a name, `**`
/// any number of folders. A pattern with a slash before its end is relative to the folder. A slash
/// at the end matches folders only. `!` includes paths again. The last matching pattern applies.
class PathPatterns {
 public:
  /// The cost of comparing an ordinary pattern with a path; a long pattern costs a multiple.
  static constexpr std::uint64_t kStepsOfCheck = 64;

  /// One line of a file; blank lines, comments and lines longer than any path are ignored.
  void add(std::string_view line);
  void add_lines(std::string_view text);
  bool empty() const { return patterns_.empty(); }
  std::size_t size() const { return patterns_.size(); }

  /// The verdict on the path itself, ignoring its folders. `steps` grows by the number of compared
  /// characters.
  PathVerdict judge(std::string_view path, bool is_folder, std::uint64_t* steps = nullptr) const;
  /// Whether a file or a folder that contains it is excluded.
  bool excludes(std::string_view file, std::uint64_t* steps = nullptr) const;

 private:
  struct Pattern {
    std::vector<std::string> names;  ///< "**" for any number of folders
    bool is_exclusion = true;
    bool folders_only = false;
  };
  std::vector<Pattern> patterns_;
};

}  // namespace smurf
