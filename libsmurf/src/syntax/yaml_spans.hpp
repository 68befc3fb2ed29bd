// SPDX-License-Identifier: BSD-3-Clause
// Finds the ends of YAML values: yaml-cpp reports only where they begin.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "smurf/yaml.hpp"

namespace smurf {

/// Skips anchors (`&a`), tags (`!t`), and the spaces and comments after them.
std::uint32_t skip_properties(std::string_view text, std::uint32_t at);
/// Skips blanks, line ends and comments.
std::uint32_t skip_blank(std::string_view text, std::uint32_t at);

struct ScalarExtent {
  yaml::Style style = yaml::Style::plain;
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  bool closed = true;  ///< false: the quote is not closed
};
/// `at` is yaml-cpp's mark, `value` the decoded text.
ScalarExtent scalar_extent(std::string_view text, std::uint32_t at, std::string_view value);

/// End of a flow collection whose last child ends at `at`: one past the bracket.
std::uint32_t flow_end(std::string_view text, std::uint32_t at);

}  // namespace smurf
