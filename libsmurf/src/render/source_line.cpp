// SPDX-License-Identifier: BSD-3-Clause
#include "render/source_line.hpp"

#include <algorithm>

namespace smurf::render {
namespace {

constexpr std::string_view kEllipsis = "...";
constexpr int kFewestColumns = 20;
constexpr int kTabColumns = 8; ///< a tab is counted at its widest when a line is cut

bool is_blank(const Glyph& glyph) {
  return glyph.is_tab || glyph.text == " " || glyph.text.empty();
}

} // namespace

SourceLine::SourceLine(std::string_view line, std::uint32_t offset)
    : glyphs_(to_glyphs(line, offset)), last_(glyphs_.size()) {}

int SourceLine::columns_between(std::size_t first, std::size_t last) const {
  int columns = 0;
  for (std::size_t i = first; i < last; ++i) {
    columns += glyphs_[i].is_tab ? kTabColumns : glyphs_[i].width;
  }
  return columns;
}

/// The glyph that holds the byte, or the end.
std::size_t SourceLine::index_of(std::uint32_t offset) const {
  const auto after = std::upper_bound(
      glyphs_.begin(), glyphs_.end(), offset,
      [](std::uint32_t value, const Glyph& glyph) { return value < glyph.offset; });
  if (after == glyphs_.begin()) return 0;
  const auto before = static_cast<std::size_t>(after - glyphs_.begin()) - 1;
  const bool is_past_end = offset >= glyphs_[before].offset + glyphs_[before].size;
  return is_past_end ? glyphs_.size() : before;
}

void SourceLine::cut(int columns, std::span<const ByteRange> marks) {
  const int room = std::max(columns, kFewestColumns);
  if (columns_between(0, glyphs_.size()) <= room) return;
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

  // Half of what the mark leaves free, but a few columns at least, is for what stands before it;
  // what one side does not need goes to the other.
  const auto fits = [&](std::size_t first, std::size_t last, int columns_free) {
    return columns_between(first, last) <= columns_free;
  };
  const int before = std::max((inside - columns_between(begin, end)) / 2, inside / 8);
  first_ = fits(0, end, inside) ? 0 : begin;
  while (first_ > 0 && fits(first_ - 1, begin, before))
    --first_;
  last_ = begin;
  while (last_ < glyphs_.size() && fits(first_, last_ + 1, inside))
    ++last_;
  while (first_ > 0 && last_ == glyphs_.size() && fits(first_ - 1, last_, inside))
    --first_;
}

std::string SourceLine::text() const {
  std::string out(is_cut_left() ? kEllipsis : "");
  for (std::size_t i = first_; i < last_; ++i)
    out += glyphs_[i].text;
  if (is_cut_right()) return out.append(kEllipsis);
  out.erase(out.find_last_not_of(" \t") + 1);
  return out;
}

std::string SourceLine::lead(std::uint32_t offset, char fill) const {
  const std::size_t index = index_of(offset);
  if (index < first_) return {};
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

  std::size_t columns = begin < first_ ? kEllipsis.size() : 0;
  for (std::size_t i = std::max(begin, first_); i < std::min(end, last_); ++i) {
    columns += glyphs_[i].is_tab ? 1U : static_cast<std::size_t>(glyphs_[i].width);
  }
  if (end > last_ || (begin >= last_ && is_cut_right())) columns += kEllipsis.size();
  return std::string(std::max<std::size_t>(columns, 1), fill);
}

bool SourceLine::is_first_text(std::uint32_t offset) const {
  const std::size_t end = index_of(offset);
  return std::all_of(glyphs_.begin(), glyphs_.begin() + static_cast<std::ptrdiff_t>(end), is_blank);
}

} // namespace smurf::render
