// SPDX-License-Identifier: BSD-3-Clause
// Foreign text made fit for a terminal: no control characters, known width.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace smurf::render {

/// One character of a source line as it is shown.
struct Glyph {
  std::string_view text;     ///< into the source, or U+FFFD; empty for a byte order mark
  std::uint32_t offset = 0;  ///< of the character in the source
  std::uint32_t size = 1;    ///< bytes in the source
  int width = 1;             ///< columns; meaningless for a tab
  bool is_tab = false;
};

/// The characters of a line. Control characters, characters that turn the direction of writing and
/// invalid bytes become U+FFFD.
std::vector<Glyph> to_glyphs(std::string_view line, std::uint32_t offset);

/// A message or path on one line: control characters and the like as "\n" or "\u001b". No line
/// that begins with it is a command of a workflow ("::error::").
std::string escape(std::string_view text);

/// Lines as escape() has them; tabs and line ends, of either kind, stay.
std::string escape_lines(std::string_view text);

/// Text of a source for a browser, in which columns are those of SourceMap::position(): a character
/// for each that begins, U+FFFD for the same as in a terminal. Tabs and line ends stay.
std::string visible_lines(std::string_view text);

/// Columns of text that went through escape().
std::size_t width_of(std::string_view text);

}  // namespace smurf::render
