// SPDX-License-Identifier: BSD-3-Clause
// A piece of one source with its marks drawn under the lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/paint.hpp"
#include "render/source_line.hpp"
#include "smurf/render.hpp"
#include "smurf/source.hpp"

namespace smurf::render {

struct Mark {
  Span span;
  std::string_view text;
  Ink ink = Ink::frame;
  char line = '-';
};

/// A frame has a main mark, which may span lines, and others, which are shown on their first line.
class Frame {
 public:
  /// Precondition: the spans are inside readable sources, and `others` are in the source of `main`.
  Frame(const SourceMap& sources, const TextStyle& style, Mark main, std::vector<Mark> others,
        std::uint32_t context_lines);

  /// Digits of the largest line number, by which the rows before and after are indented.
  std::size_t gutter() const { return gutter_; }
  /// The rows with their gutters, from the first empty one to the last.
  std::string draw() const;

 private:
  struct Lines {
    std::uint32_t first = 1;
    std::uint32_t last = 1;
  };
  Lines lines_of(Span span) const;
  void share_mark();
  void choose_lines(std::uint32_t context_lines);
  /// The part of the mark on its first line.
  ByteRange on_first_line(Span span) const;

  int room() const;
  ByteRange last_of_bracket() const;
  std::string gap(std::uint32_t before, std::uint32_t after) const;
  std::string source_rows(std::uint32_t number) const;
  std::string mark_row(const SourceLine& line, const Mark& mark) const;
  std::string opening_row(const SourceLine& line) const;
  std::string closing_row(const SourceLine& line) const;
  std::string row(std::string_view number, std::string_view text) const;
  std::string bracket(std::uint32_t line, bool opens_beside) const;

  const SourceMap& sources_;
  const TextStyle& style_;
  Painter paint_;
  Mark main_;
  Lines main_lines_;
  bool has_bracket_ = false;  ///< the main mark spans lines
  std::vector<Mark> others_;
  std::vector<std::uint32_t> shown_;  ///< ascending
  std::size_t gutter_ = 1;
};

}  // namespace smurf::render
