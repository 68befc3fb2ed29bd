// SPDX-License-Identifier: BSD-3-Clause
// Characters in names that terminals and build servers interpret.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "base/ranges.hpp"
#include "base/text/utf8.hpp"

namespace smurf {

inline bool is_byte_order_mark(char32_t c) { return c == 0xFEFF; }

/// GitHub, Azure and TeamCity treat a line that contains one of these as a command.
inline bool starts_mark(std::string_view rest) {
  return rest.starts_with("##[") || rest.starts_with("##vso[") || rest.starts_with("##teamcity[");
}

/// Whether a text ends with a character that is white space in .NET, in which GitHub's runner is
/// written.
inline bool ends_with_space(std::string_view text) {
  if (text.empty()) return false;
  if (text.back() == ' ' || (text.back() >= '\t' && text.back() <= '\r')) return true;
  constexpr std::string_view kSpaces[] = {"\u0085", "\u00A0", "\u1680", "\u2000", "\u2001",
                                          "\u2002", "\u2003", "\u2004", "\u2005", "\u2006",
                                          "\u2007", "\u2008", "\u2009", "\u200A", "\u2028",
                                          "\u2029", "\u202F", "\u205F", "\u3000"};
  return ranges::any_of(kSpaces, [&](auto space) { return text.ends_with(space); });
}

/// GitHub also treats a line that begins with "::" as a command, even after white space. A name may
/// be at the start of a line, or be moved there by wrapping.
inline bool starts_command(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  return starts_mark(rest) ||
         (rest.starts_with("::") && (at == 0 || ends_with_space(text.substr(0, at))));
}

/// Whether a format for programs escapes the character `c` at this place.
inline bool is_misread(std::string_view text, std::size_t at, char32_t c) {
  return utf8::is_layout(c) || is_byte_order_mark(c) || starts_command(text, at);
}

}  // namespace smurf
