// SPDX-License-Identifier: BSD-3-Clause
#include "render/source_line.hpp"

#include <algorithm>

#include "base/text/utf8.hpp"
#include "smurf/source.hpp"

namespace smurf::render {
namespace {

constexpr std::string_view kEllipsis = "...";
constexpr int kFewestColumns = 20;
constexpr int kTabColumns = 8;  ///< a tab has its greatest width when a line is truncated

constexpr std::size_t kBytesPerColumn = 4;  ///< most bytes of a character, without combining marks

int columns_of(const Glyph& glyph) { return glyph.is_tab ? kTabColumns : glyph.width; }

/// The part of a very long line that can be shown around a place, so that a file of one line is not
/// decoded completely for each finding.
ByteRange part_around(std::string_view line, std::size_t place, int room) {
  const auto columns = static_cast<std::size_t>(room);
  const std::string_view near =
      line.substr(place - std::min(place, columns), std::min(place, columns) + columns);
  const bool is_ascii = utf8::ascii_prefix(near) == near.size();
  const std::size_t reach = is_ascii ? columns : kBytesPerColumn * columns;
  std::size_t begin = place - std::min(place, reach);
  std::size_t end = std::min(line.size(), place + reach);
  while (begin > 0 && utf8::is_continuation(line[begin])) --begin;
  while (end < line.size() && utf8::is_continuation(line[end])) ++end;
  return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

}  // namespace

SourceLine::SourceLine(std::string_view line, std::uint32_t offset, int columns,
                       std::span<const ByteRange> marks)
    : line_(line), offset_(offset) {
  const int room = std::max(columns, kFewestColumns);
  const std::uint32_t place = marks.empty() ? offset : std::max(offset, marks.front().begin);
  const ByteRange part = part_around(line, place - offset, room);
  glyphs_ = to_glyphs(line.substr(part.begin, part.end - part.begin), offset + part.begin);
  last_ = glyphs_.size();
  const bool is_whole = part.end - part.begin == line.size();
  if (!is_whole || columns_between(0, glyphs_.size()) > room) cut(room, marks);
  const std::uint32_t end = offset + part.end;
  shown_.begin = first_ < glyphs_.size() ? glyphs_[first_].offset : end;
  shown_.end = last_ < glyphs_.size() ? glyphs_[last_].offset : end;
}

int SourceLine::columns_between(std::size_t first, std::size_t last) const {
  int columns = 0;
  for (std::size_t i = first; i < last; ++i) columns += columns_of(glyphs_[i]);
  return columns;
}

/// The glyph that contains the byte, or the end.
std::size_t SourceLine::index_of(std::uint32_t offset) const {
  const auto after = std::upper_bound(
      glyphs_.begin(), glyphs_.end(), offset,
      [](std::uint32_t value, const Glyph& glyph) { return value < glyph.offset; });
  if (after == glyphs_.begin()) return 0;
  const auto before = static_cast<std::size_t>(after - glyphs_.begin()) - 1;
  const bool is_past_end = offset >= glyphs_[before].offset + glyphs_[before].size;
  return is_past_end ? glyphs_.size() : before;
}

void SourceLine::cut(int room, std::span<const ByteRange> marks) {
  const int inside = room - 2 * static_cast<int>(kEllipsis.size());
  std::size_t begin = marks.empty() ? 0 : index_of(marks.front().begin);
  std::size_t end = marks.empty() ? 0 : std::max(begin, index_of(marks.front().end));
  for (const ByteRange& mark : marks) {
    const std::size_t first = std::min(begin, index_of(mark.begin));
    const std::size_t last = std::max(end, index_of(mark.end));
    if (columns_between(first, last) > inside) continue;
    begin = first;
    end = last;
  }

  // Half of the free columns, but at least a few, are for the text before the marks; columns that
  // one side does not need go to the other side.
  const int before = std::max((inside - columns_between(begin, end)) / 2, inside / 8);
  const bool reaches_start = columns_between(0, end) <= inside;
  first_ = reaches_start ? 0 : begin;
  last_ = begin;
  int used = columns_between(first_, begin);
  const auto take_left = [&](int limit) {
    while (first_ > 0 && used + columns_of(glyphs_[first_ - 1]) <= limit) {
      used += columns_of(glyphs_[--first_]);
    }
  };
  take_left(before);
  while (last_ < glyphs_.size() && used + columns_of(glyphs_[last_]) <= inside) {
    used += columns_of(glyphs_[last_++]);
  }
  if (last_ == glyphs_.size()) take_left(inside);
}

std::string SourceLine::text() const {
  std::string out(is_cut_left() ? kEllipsis : "");
  for (std::size_t i = first_; i < last_; ++i) out += glyphs_[i].text;
  if (is_cut_right()) return out.append(kEllipsis);
  out.erase(out.find_last_not_of(" \t") + 1);
  return out;
}

std::string SourceLine::lead(std::uint32_t offset, char fill) const {
  if (offset < shown_.begin) return {};
  const std::size_t index = index_of(offset);
  std::string out(is_cut_left() ? kEllipsis.size() : 0, fill);
  for (std::size_t i = first_; i < std::min(index, last_); ++i) {
    if (glyphs_[i].is_tab) {
      out += '\t';
    } else {
      out.append(static_cast<std::size_t>(glyphs_[i].width), fill);
    }
  }
  return out;
}

std::string SourceLine::underline(ByteRange range, char fill) const {
  const std::size_t begin = index_of(range.begin);
  std::size_t end = index_of(range.end);
  // A mark that ends inside a character covers it.
  if (end < glyphs_.size() && glyphs_[end].offset < range.end) ++end;
  end = std::max(begin, end);

  std::size_t columns = range.begin < shown_.begin ? kEllipsis.size() : 0;
  for (std::size_t i = std::max(begin, first_); i < std::min(end, last_); ++i) {
    columns += glyphs_[i].is_tab ? 1U : static_cast<std::size_t>(glyphs_[i].width);
  }
  const bool is_in_right_dots = range.end > shown_.end || range.begin >= shown_.end;
  if (is_cut_right() && is_in_right_dots) columns += kEllipsis.size();
  return std::string(std::max<std::size_t>(columns, 1), fill);
}

bool SourceLine::is_first_text(std::uint32_t offset) const {
  std::string_view before = line_.substr(0, offset - offset_);
  if (before.starts_with(kByteOrderMark)) before.remove_prefix(kByteOrderMark.size());
  return before.find_first_not_of(" \t") == std::string_view::npos;
}

}  // namespace smurf::render
