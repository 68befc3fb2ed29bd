// SPDX-License-Identifier: BSD-3-Clause
// One source line and the columns of its marks.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "render/printable.hpp"

namespace smurf::render {

/// Half-open byte range of a source: the part of a mark on one line.
struct ByteRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

class SourceLine {
 public:
  /// Shows at most `columns` columns, chosen around the first mark and as many others as fit.
  /// `offset` is the line's place in its source; `line` must outlive the object.
  SourceLine(std::string_view line, std::uint32_t offset, int columns,
             std::span<const ByteRange> marks);

  /// The shown text: truncated with "...", without trailing white space.
  std::string text() const;
  /// The text before `offset` in the row below: `fill` for each column, tabs as tabs, so the row
  /// stays aligned for any width of a tab.
  std::string lead(std::uint32_t offset, char fill) const;
  /// `fill` for each column of the range, at least one; a truncated part is marked at the dots.
  std::string underline(ByteRange range, char fill) const;
  /// Whether there is only white space before `offset`.
  bool is_first_text(std::uint32_t offset) const;

 private:
  void cut(int room, std::span<const ByteRange> marks);
  std::uint32_t end_offset() const { return offset_ + static_cast<std::uint32_t>(line_.size()); }
  bool is_cut_left() const { return shown_.begin > offset_; }
  bool is_cut_right() const { return shown_.end < end_offset(); }
  int columns_between(std::size_t first, std::size_t last) const;
  std::size_t index_of(std::uint32_t offset) const;

  std::string_view line_;
  std::uint32_t offset_ = 0;
  std::vector<Glyph> glyphs_;  ///< of the line, or of the part around the first mark
  std::size_t first_ = 0;      ///< the glyphs shown: [first_, last_)
  std::size_t last_ = 0;
  ByteRange shown_;
};

}  // namespace smurf::render
