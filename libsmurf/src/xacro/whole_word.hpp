// SPDX-License-Identifier: BSD-3-Clause
// Names in texts that are not parsed.
#pragma once

#include <cstddef>
#include <string_view>

#include "base/text/words.hpp"

namespace smurf::xacro {

constexpr bool is_of_name(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Whether the characters from `begin` to `end` are a name, and not a part of a longer one.
constexpr bool is_whole_name(std::string_view text, std::size_t begin, std::size_t end) {
  return (begin == 0 || !is_of_name(text[begin - 1])) &&
         (end >= text.size() || !is_of_name(text[end]));
}

/// The next place of a name, from `at` on, that is no part of a longer one; npos if there is none.
/// An empty name has no place.
constexpr std::size_t find_name(std::string_view text, std::string_view name, std::size_t at = 0) {
  if (name.empty()) return std::string_view::npos;
  for (at = text.find(name, at); at != std::string_view::npos; at = text.find(name, at + 1)) {
    if (is_whole_name(text, at, at + name.size())) return at;
  }
  return std::string_view::npos;
}

}  // namespace smurf::xacro
