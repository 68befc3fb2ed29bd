// SPDX-License-Identifier: BSD-3-Clause
// Finds the equal lines of two texts, in order: the unchanged lines of a unified diff.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::tools {

/// Lines including their line ends, so that a change of line ends is visible.
std::vector<std::string_view> lines_of(std::string_view text);

/// Equal consecutive lines in both texts.
struct EqualLines {
  std::size_t before = 0;  ///< the first of them, from 0
  std::size_t after = 0;
  std::size_t size = 0;
};

/// In time linear in the number of lines: minimal for few changes, and close to minimal
/// otherwise.
std::vector<EqualLines> equal_lines(const std::vector<std::string_view>& before,
                                    const std::vector<std::string_view>& after);

/// The changes in the format of `diff -u`, without its two header lines.
std::string unified_hunks(std::string_view before, std::string_view after);

}  // namespace smurf::tools
