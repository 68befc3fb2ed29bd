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

}  // namespace smurf::xacro
