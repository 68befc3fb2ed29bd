// SPDX-License-Identifier: BSD-3-Clause
// A checked file may contain anything, and printed characters may move the cursor, colour the
// screen or hide text, so no text of a file reaches the terminal unescaped.
#include "render/printable.hpp"

#include "base/text/misread.hpp"
#include "base/text/utf8.hpp"

namespace smurf::render {
namespace {

using utf8::kReplacement;

bool is_unsafe(char32_t c) { return utf8::is_control(c) || utf8::is_layout(c); }

void append_escape(std::string& out, char32_t c) {
  switch (c) {
  case '\n': out += "\\n"; return;
  case '\r': out += "\\r"; return;
  case '\t': out += "\\t"; return;
  default: break;
  }
  utf8::append_escape(out, c);
}

}  // namespace

std::vector<Glyph> to_glyphs(std::string_view line, std::uint32_t offset) {
  std::vector<Glyph> glyphs;
  glyphs.reserve(line.size());
  std::size_t at = 0;
  while (at < line.size()) {
    const utf8::CodePoint point = utf8::decode(line.substr(at));
    Glyph glyph;
    glyph.offset = offset + static_cast<std::uint32_t>(at);
    glyph.size = static_cast<std::uint32_t>(point.size);
    glyph.text = line.substr(at, point.size);
    if (point.value == '\t') {
      glyph.is_tab = true;
    } else if (is_byte_order_mark(point.value)) {
      glyph.text = {};
      glyph.width = 0;
    } else if (is_unsafe(point.value) || point.value == 0xFFFD || starts_mark(line.substr(at))) {
      glyph.text = kReplacement;
    } else {
      glyph.width = utf8::display_width(point.value);
    }
    glyphs.push_back(glyph);
    at += point.size;
  }
  return glyphs;
}

std::string escape(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  std::size_t at = 0;
  while (at < text.size()) {
    const utf8::CodePoint point = utf8::decode(text.substr(at));
    if (utf8::is_control(point.value) || is_misread(text, at, point.value)) {
      append_escape(out, point.value);
    } else if (point.value == 0xFFFD) {
      out += kReplacement;
    } else {
      out += text.substr(at, point.size);
    }
    at += point.size;
  }
  return out;
}

std::string escape_lines(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("\t\n");
    const std::string_view part = text.substr(0, end);
    const bool is_dos = part.ends_with('\r') && end != std::string_view::npos && text[end] == '\n';
    out += escape(part.substr(0, part.size() - (is_dos ? 1 : 0)));
    if (is_dos) out += '\r';
    if (end == std::string_view::npos) break;
    out += text[end];
    text.remove_prefix(end + 1);
  }
  return out;
}

std::string visible_lines(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    const bool is_space = point.value == '\t' || point.value == '\n';
    const bool is_carriage_return = text.starts_with("\r\n");
    const bool is_inside = point.size == 1 && utf8::is_continuation(text.front());
    const bool is_hidden = is_unsafe(point.value) || is_byte_order_mark(point.value);
    if (is_space || !(is_hidden || point.value == 0xFFFD)) {
      out += text.substr(0, point.size);
    } else if (!is_carriage_return && !is_inside) {
      out += kReplacement;
    }
    text.remove_prefix(point.size);
  }
  return out;
}

std::string safe_file_name(std::string_view name) {
  constexpr std::string_view kUnsafe = "/\\\"'`$&|;<>*?";
  std::string safe;
  for (const char c : escape(name)) {
    safe += kUnsafe.find(c) == std::string_view::npos ? c : '_';
  }
  constexpr std::string_view kUnsafeFirst = "-. ";
  if (safe.empty() || kUnsafeFirst.find(safe.front()) != std::string_view::npos) {
    safe.insert(0, 1, '_');
  }
  return safe;
}

std::size_t width_of(std::string_view text) {
  std::size_t width = 0;
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    width += static_cast<std::size_t>(utf8::display_width(point.value));
    text.remove_prefix(point.size);
  }
  return width;
}

}  // namespace smurf::render
