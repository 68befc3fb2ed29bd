// SPDX-License-Identifier: BSD-3-Clause
// Characters of a name that a screen or a build server takes for more than a name.
#pragma once

#include <cstddef>
#include <string_view>

#include "base/utf8.hpp"

namespace smurf {

inline bool is_byte_order_mark(char32_t c) { return c == 0xFEFF; }

/// GitHub and Azure take a line that holds one of these for a command.
inline bool starts_mark(std::string_view rest) {
  return rest.starts_with("##[") || rest.starts_with("##vso[");
}

/// GitHub does the same with a line that begins with "::". A name may be at the start of a line, or
/// come there where text is wrapped.
inline bool starts_command(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  return starts_mark(rest) || (rest.starts_with("::") && (at == 0 || text[at - 1] == ' '));
}

/// Whether the character `c`, at this place, is one that a format for programs escapes.
inline bool is_misread(std::string_view text, std::size_t at, char32_t c) {
  return utf8::is_layout(c) || is_byte_order_mark(c) || starts_command(text, at);
}

}  // namespace smurf
