// SPDX-License-Identifier: BSD-3-Clause
// Which lines of two texts are equal, in order: what a unified diff leaves out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::tools {

/// Lines with their line ends, so that a change of these shows too.
std::vector<std::string_view> lines_of(std::string_view text);

/// Equal lines that follow each other in both texts.
struct EqualLines {
  std::size_t before = 0;  ///< the first of them, from 0
  std::size_t after = 0;
  std::size_t size = 0;
};

/// In time linear in the number of lines: minimal where the changes are few, and close to that
/// elsewhere.
std::vector<EqualLines> equal_lines(const std::vector<std::string_view>& before,
                                    const std::vector<std::string_view>& after);

/// The changes as `diff -u` shows them, without its two lines of names.
std::string unified_hunks(std::string_view before, std::string_view after);

}  // namespace smurf::tools
