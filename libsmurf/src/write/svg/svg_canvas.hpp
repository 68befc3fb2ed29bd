// SPDX-License-Identifier: BSD-3-Clause
// A sheet of SVG: metres in, pixels out, and places for labels. Sheets can be below each other.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "write/text/long_text.hpp"

namespace smurf {

using Point2 = std::array<double, 2>;

/// An axis-aligned rectangle; empty until a point is added.
struct Box2 {
  Point2 low{1e300, 1e300};
  Point2 high{-1e300, -1e300};

  bool is_empty() const { return low[0] > high[0]; }
  void add(const Point2& point);
  bool overlaps(const Box2& other) const;
  double size(std::size_t axis) const { return high[axis] - low[axis]; }
};

/// Counter-clockwise, without points on the edges.
std::vector<Point2> convex_hull(std::vector<Point2> points);

/// x goes right, y up. Text is escaped here.
class SvgCanvas {
 public:
  /// `world` is the area to show, in metres. `height` is that of a sheet below, which limits the
  /// scale unless it is far larger.
  SvgCanvas(const Box2& world, double height, std::string title);
  /// A sheet below another one, with the same scale and horizontal extent. Clips parts that are too
  /// high.
  SvgCanvas(const SvgCanvas& upper, const Box2& world, std::string title);

  double height() const { return height_; }
  /// Begins the picture, with space for a sheet below.
  void open(double below);
  /// Continues the picture of the sheet above, which is complete.
  void open_below(SvgCanvas& upper);
  /// Draws the border.
  void close_sheet();
  /// The id of the clip path of the sheet.
  std::string clip() const { return top_ > 0 ? "lower" : "sheet"; }
  /// Whether labels were omitted because no place was free.
  bool lacks_names() const { return lost_names_ > 0; }

  Point2 to_pixels(const Point2& world) const;
  double scale() const { return scale_; }  ///< pixels per metre
  Box2 sheet() const { return {{kMargin, kMargin}, {width_ - kMargin, height_ - kMargin}}; }

  void add(std::string_view markup) {
    make_room(text_);
    text_ += markup;
  }
  /// Grid lines at round numbers of metres, with their numbers at the border.
  void add_grid();
  /// Keeps labels away from an area.
  void occupy(const Box2& pixels);
  /// Adds a label beside a point where it overlaps no other label; a line connects a label that is
  /// farther away. Omits it if no place is free.
  void add_label(const Point2& pixels, std::string_view text);
  /// Moves the whole picture out, because it may be long.
  std::string finish(std::string_view legend);

 private:
  static constexpr double kMargin = 48;
  static constexpr double kCell = 16;

  void lay_out();
  void add_title();
  std::optional<Box2> place_of_label(const Point2& at, double width) const;
  bool is_free(const Box2& pixels) const;
  /// Calls `visit(cell)` for the cells that a box covers, until it returns false.
  template <class Visit>
  bool for_each_cell(const Box2& pixels, const Visit& visit) const;

  Point2 origin_{};  ///< metres at the lower left corner of the sheet
  double scale_ = 1;
  double width_ = 0;
  double height_ = 0;
  double top_ = 0;  ///< of the sheet in the picture
  std::string title_;
  std::size_t lost_names_ = 0;
  std::string text_;
  std::size_t columns_ = 0, rows_ = 0;
  /// Occupied areas, by squares of kCell pixels of the sheet: a label is only compared with nearby
  /// ones.
  std::vector<std::vector<Box2>> cells_;
};

/// Rounded to a hundredth of a pixel.
std::string pixels(double value);
std::string pixels(const Point2& point);  ///< "x y"

}  // namespace smurf
