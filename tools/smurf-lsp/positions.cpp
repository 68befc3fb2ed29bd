// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/positions.hpp"

#include <algorithm>

#include "base/text/utf8.hpp"
#include "smurf/source.hpp"

namespace smurf::lsp {
namespace {

/// The bytes and units of the first character of a text.
struct Character {
  std::size_t bytes = 1;
  std::uint32_t units = 1;
};

/// Clients send UTF-8. An invalid byte of a file counts as one character.
Character first_of(std::string_view text, Encoding encoding) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t promised = lead < 0xc0 ? 1 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  std::size_t bytes = 1;
  while (bytes < promised && bytes < text.size() && utf8::is_continuation(text[bytes])) {
    ++bytes;
  }
  if (bytes < promised) return {1, 1};
  if (encoding == Encoding::utf8) return {bytes, static_cast<std::uint32_t>(bytes)};
  return {bytes, encoding == Encoding::utf16 && bytes == 4 ? 2U : 1U};
}

std::string_view without_line_end(std::string_view line) {
  if (line.ends_with('\n')) line.remove_suffix(1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

std::string_view to_string(Encoding encoding) {
  switch (encoding) {
  case Encoding::utf8: return "utf-8";
  case Encoding::utf16: return "utf-16";
  case Encoding::utf32: return "utf-32";
  }
  return {};
}

std::uint32_t units_in(std::string_view text, Encoding encoding) {
  std::uint32_t units = 0;
  while (!text.empty()) {
    const Character first = first_of(text, encoding);
    units += first.units;
    text.remove_prefix(first.bytes);
  }
  return units;
}

std::size_t bytes_of(std::string_view line, std::uint32_t units, Encoding encoding) {
  std::size_t bytes = 0;
  std::uint32_t passed = 0;
  while (bytes < line.size() && passed < units) {
    const Character first = first_of(line.substr(bytes), encoding);
    passed += first.units;
    if (passed > units) break;  // within a character
    bytes += first.bytes;
  }
  return bytes;
}

std::size_t offset_in(std::string_view text, const Json& position, Encoding encoding) {
  const std::uint32_t line = number_at(position, {"line"}).value_or(0);
  std::size_t begin = 0;
  for (std::uint32_t i = 0; i < line; ++i) {
    const std::size_t end = text.find('\n', begin);
    if (end == std::string_view::npos) return text.size();
    begin = end + 1;
  }
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  const std::string_view rest = without_line_end(text.substr(begin, end - begin));
  return begin + bytes_of(rest, number_at(position, {"character"}).value_or(0), encoding);
}

Json Positions::position(SourceId source, std::uint32_t offset) const {
  const std::string_view text = sources_.text(source);
  offset = std::min(offset, static_cast<std::uint32_t>(text.size()));
  for (int i = 0; i < 3 && offset < text.size() && utf8::is_continuation(text[offset]); ++i) {
    ++offset;  // to a whole character
  }
  // Starts at the nearest place counted before: a file may be one line with thousands of places.
  const smurf::Position place = sources_.position(source, offset);
  const Span before{source, sources_.line_begin(source, place.line), offset};
  std::uint32_t units = before.end - before.begin;
  if (encoding_ != Encoding::utf8) {
    units = place.column - 1;
    if (place.line == 1 && offset > 0 && text.starts_with(kByteOrderMark)) ++units;  // the mark
  }
  if (encoding_ == Encoding::utf16) units += sources_.wide_characters(before);
  return {{"line", place.line - 1}, {"character", units}};
}

Json Positions::range(Span span) const {
  return {{"start", position(span.source, span.begin)}, {"end", position(span.source, span.end)}};
}

std::uint32_t Positions::offset(SourceId source, const Json& position) const {
  const std::string_view text = sources_.text(source);
  const std::uint32_t line = number_at(position, {"line"}).value_or(0);
  if (line >= sources_.line_count(source)) return static_cast<std::uint32_t>(text.size());
  const Span span = sources_.line_span(source, line + 1);
  const std::uint32_t units = number_at(position, {"character"}).value_or(0);
  return span.begin + static_cast<std::uint32_t>(bytes_of(sources_.text(span), units, encoding_));
}

}  // namespace smurf::lsp
