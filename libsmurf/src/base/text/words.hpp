// SPDX-License-Identifier: BSD-3-Clause
// Splits text at the blanks of XML and YAML, and compares words.
#pragma once

#include <initializer_list>
#include <string_view>

namespace smurf {

/// The characters that separate words.
inline constexpr std::string_view kBlanks = " \t\r\n";
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Without the blanks around it.
constexpr std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// `a == b`, without a call if the size, the first or the last byte differs, as in most look-ups:
/// `ixx` and `ixy` differ in the last byte.
constexpr bool is_same(std::string_view a, std::string_view b) {
  return a.size() == b.size() &&
         (a.empty() || (a.front() == b.front() && a.back() == b.back() && a == b));
}

inline bool is_one_of(std::string_view text, std::initializer_list<std::string_view> texts) {
  for (const std::string_view one : texts) {
    if (is_same(one, text)) return true;
  }
  return false;
}

/// The next word of `text` from `at` on; moves `at` to its end. Empty if there is none.
constexpr std::string_view next_word(std::string_view text, std::size_t& at) {
  while (at < text.size() && is_blank(text[at])) ++at;
  const std::size_t begin = at;
  while (at < text.size() && !is_blank(text[at])) ++at;
  return text.substr(begin, at - begin);
}

}  // namespace smurf
