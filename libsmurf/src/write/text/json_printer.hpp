// SPDX-License-Identifier: BSD-3-Clause
// Prints nested values as JSON, up to a given size.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/pose.hpp"
#include "smurf/source.hpp"

namespace smurf {

/// Writes commas and line ends in the right places. When the text is longer than `most`, it stops
/// growing, and take() returns none.
class JsonPrinter {
 public:
  /// The layout of an object or list: one line per part, or all on one line.
  enum class Layout : std::uint8_t { block, line };

  explicit JsonPrinter(std::uint64_t most) : most_(most) {}

  void begin_object(Layout layout = Layout::line) { begin('{', layout); }
  void begin_list(Layout layout = Layout::line) { begin('[', layout); }
  /// Ends the innermost object or list.
  void end();
  /// The key of the next value; in objects only.
  void key(std::string_view name);
  /// A key and its text.
  void member(std::string_view name, std::string_view value);
  /// A key and a list of numbers.
  void member(std::string_view name, std::initializer_list<double> values);

  void text(std::string_view value);
  /// JSON has no infinite numbers: those are null.
  void number(double value);
  void integer(std::int64_t value);
  void boolean(bool value);
  void null();
  /// A list of numbers.
  void numbers(std::span<const double> values);
  void vector(const Vector3& value);
  /// {"position": [x, y, z], "orientation": {"w": ...}}
  void pose(const Pose& value);

  /// {"file": "arm.urdf", "line": 3, "column": 5}
  void place(Span span, const SourceMap& sources);

  bool is_full() const { return out_.size() > most_; }
  /// The text with a line end; none if it is too large.
  std::optional<std::string> take();

 private:
  struct Open {
    char end;
    Layout layout;
    bool is_empty = true;
  };

  void begin(char bracket, Layout layout);
  void break_line(std::size_t depth);
  /// Writes the separator between values of a list.
  void begin_value();

  std::uint64_t most_;
  std::string out_;
  std::vector<Open> open_;
  bool has_key_ = false;  ///< the next value is the first of its list
};

}  // namespace smurf
