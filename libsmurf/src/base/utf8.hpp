// SPDX-License-Identifier: BSD-3-Clause
// UTF-8: validity, code points and terminal width.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace smurf::utf8 {

/// A byte of a sequence that is not its first.
inline bool is_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Counts lead bytes, so that any byte string has a count.
std::size_t count_code_points(std::string_view text);

/// Number of ASCII bytes at the front.
std::size_t ascii_prefix(std::string_view text);

/// Offset of the first byte that is not part of valid UTF-8 (overlong forms and surrogates are
/// not).
std::optional<std::size_t> find_invalid(std::string_view text);

struct CodePoint {
  char32_t value = 0;
  std::size_t size = 1;  ///< bytes; 1 for an invalid byte
};
/// Precondition: text is not empty. An invalid byte decodes to U+FFFD.
CodePoint decode(std::string_view text);
/// Precondition: a code point of Unicode, no surrogate.
void append(std::string& text, char32_t code_point);

/// Columns a terminal uses: 2 for East Asian wide and emoji, 0 for combining marks.
int display_width(char32_t code_point);

}  // namespace smurf::utf8
