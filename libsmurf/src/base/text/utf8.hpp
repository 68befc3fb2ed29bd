// SPDX-License-Identifier: BSD-3-Clause
// UTF-8: validity, code points and terminal width.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace smurf::utf8 {

/// Whether the byte continues a sequence.
inline bool is_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Counts the first bytes of sequences, so any byte string has a count.
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

inline constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  ///< U+FFFD

/// C0 (including tab and line ends), DEL and C1, where some terminals begin a sequence.
inline bool is_control(char32_t code_point) {
  return code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0);
}

/// Line and paragraph separators, and marks that reorder the following text on the screen.
inline bool is_layout(char32_t code_point) {
  return code_point == 0x061C || code_point == 0x200E || code_point == 0x200F ||
         (code_point >= 0x2028 && code_point <= 0x202E) ||
         (code_point >= 0x2066 && code_point <= 0x2069);
}

/// Whether a name may be suggested and written into a file unchanged: valid UTF-8 without control,
/// layout and invalid characters.
bool is_printable(std::string_view text);

/// Appends "\\u001b", as JSON, YAML and messages have it. Precondition: below U+10000.
void append_escape(std::string& text, char32_t code_point);

/// For formats without escapes: control characters (except tab and newline), invalid bytes, U+FFFE
/// and U+FFFF become U+FFFD.
std::string replace_controls(std::string_view text);

/// Columns a terminal uses: 2 for East Asian wide and emoji, 0 for combining marks.
int display_width(char32_t code_point);

}  // namespace smurf::utf8
