// SPDX-License-Identifier: BSD-3-Clause
// Makes text of files safe for a terminal: without control characters, with a known width.
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

/// The characters of a line. Control characters, characters that change the text direction, and
/// invalid bytes become U+FFFD.
std::vector<Glyph> to_glyphs(std::string_view line, std::uint32_t offset);

/// A message or path on one line: control and similar characters become "\n" or "\u001b". The
/// result is never a command of a workflow ("::error::").
std::string escape(std::string_view text);

/// Escapes lines like escape(), but keeps tabs and line ends of both kinds.
std::string escape_lines(std::string_view text);

/// Source text for a browser, with the columns of SourceMap::position(): one character for each
/// character of the source, U+FFFD as in a terminal. Tabs and line ends are kept.
std::string visible_lines(std::string_view text);

/// Makes a safe name for a file or folder from a name that others chose: it is not hidden, no
/// option, not "." or "..", and has no '/', control characters, or characters that shells
/// interpret.
std::string safe_file_name(std::string_view name);

/// Columns of an escaped text.
std::size_t width_of(std::string_view text);

}  // namespace smurf::render
