// SPDX-License-Identifier: BSD-3-Clause
// Texts as people write them.
#pragma once

#include <string_view>

namespace smurf {

/// What separates words in YAML and XML.
inline constexpr std::string_view kBlanks = " \t\r\n";

/// Without the blanks around it.
inline std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace smurf
