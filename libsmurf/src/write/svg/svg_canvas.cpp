// SPDX-License-Identifier: BSD-3-Clause
#include "write/svg/svg_canvas.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "base/text/utf8.hpp"

namespace smurf {
namespace {

constexpr double kFontSize = 13;
constexpr double kLegendHeight = 26;
constexpr double kTitleHeight = 34;
constexpr double kNumbersHeight = 30;

double cross(const Point2& o, const Point2& a, const Point2& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

/// 1, 2 or 5 times a power of ten, at least `smallest`.
double round_step(double smallest) {
  const double power = std::pow(10, std::floor(std::log10(smallest)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= smallest) return factor * power;
  }
  return 10 * power;
}

}  // namespace

void Box2::add(const Point2& point) {
  for (std::size_t i = 0; i < 2; ++i) {
    low[i] = std::min(low[i], point[i]);
    high[i] = std::max(high[i], point[i]);
  }
}

bool Box2::overlaps(const Box2& other) const {
  return low[0] < other.high[0] && other.low[0] < high[0] && low[1] < other.high[1] &&
         other.low[1] < high[1];
}

std::vector<Point2> convex_hull(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point2> hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t start = hull.size();
    for (auto at = begin; at != end; ++at) {
      while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), *at) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*at);
    }
    hull.pop_back();
  };
  add_chain(points.begin(), points.end());
  add_chain(points.rbegin(), points.rend());
  return hull;
}

SvgCanvas::SvgCanvas(const Box2& world, double height, std::string title)
    : title_(std::move(title)) {
  constexpr double kLongSide = 860;
  constexpr double kShortSide = 420;
  Box2 shown = world;
  if (shown.is_empty()) shown.add({0, 0});
  const double largest = std::max({shown.size(0), shown.size(1), 1.0});
  for (std::size_t i = 0; i < 2; ++i) {
    const double border = 0.06 * largest + std::max(0.0, 0.5 - shown.size(i)) / 2;
    shown.low[i] -= border;
    shown.high[i] += border;
  }
  constexpr double kMuchHigher = 8;
  const double size = std::max(shown.size(0), shown.size(1));
  const double with_border = 1.12 * height;
  scale_ = kLongSide / (with_border < kMuchHigher * size ? std::max(size, with_border) : size);
  Point2 side{};
  for (std::size_t i = 0; i < 2; ++i) {
    side[i] = std::max(kShortSide, scale_ * shown.size(i));
    origin_[i] = (shown.low[i] + shown.high[i]) / 2 - side[i] / scale_ / 2;
  }
  width_ = side[0] + 2 * kMargin;
  height_ = side[1] + 2 * kMargin;
  lay_out();
}

SvgCanvas::SvgCanvas(const SvgCanvas& upper, const Box2& world, std::string title)
    : scale_(upper.scale_), width_(upper.width_), title_(std::move(title)) {
  constexpr double kShortSide = 180;
  constexpr double kLongSide = 1200;
  Box2 shown = world;
  if (shown.is_empty()) shown.add({0, 0});
  const double border = 0.06 * std::max(shown.size(1), 1.0);
  const double side =
      std::min(std::max(kShortSide, scale_ * (shown.size(1) + 2 * border)), kLongSide);
  origin_ = {upper.origin_[0], (shown.low[1] + shown.high[1]) / 2 - side / scale_ / 2};
  height_ = side + 2 * kMargin;
  top_ = upper.top_ + upper.height_;
  lay_out();
}

void SvgCanvas::lay_out() {
  columns_ = static_cast<std::size_t>(width_ / kCell) + 1;
  rows_ = static_cast<std::size_t>(height_ / kCell) + 1;
  cells_.resize(columns_ * rows_);
}

void SvgCanvas::open(double below) {
  const std::string width = pixels(width_);
  const std::string height = pixels(height_ + below + kLegendHeight);
  text_ += "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height +
           "\" font-family=\"sans-serif\" font-size=\"" + pixels(kFontSize) + "\">\n<title>" +
           escape_xml(title_) +
           "</title>\n<style>.name{fill:#111;stroke:#fff;stroke-width:3;stroke-linejoin:round;"
           "paint-order:stroke}</style>\n<rect width=\"" +
           width + "\" height=\"" + height + "\" fill=\"#fff\"/>\n";
  add_title();
}

void SvgCanvas::open_below(SvgCanvas& upper) {
  text_ = std::move(upper.text_);
  text_ += "<g transform=\"translate(0 " + pixels(top_) + ")\">\n";
  add_title();
}

void SvgCanvas::add_title() {
  text_ += "<text x=\"" + pixels(kMargin) + "\" y=\"26\" font-size=\"15\" font-weight=\"bold\">" +
           escape_xml(title_) + "</text>\n";
}

void SvgCanvas::close_sheet() {
  const Box2 area = sheet();
  text_ += "<rect x=\"" + pixels(area.low[0]) + "\" y=\"" + pixels(area.low[1]) + "\" width=\"" +
           pixels(area.size(0)) + "\" height=\"" + pixels(area.size(1)) +
           "\" fill=\"none\" stroke=\"#999\"/>\n";
  if (top_ > 0) text_ += "</g>\n";
}

template <class Visit>
bool SvgCanvas::for_each_cell(const Box2& pixels, const Visit& visit) const {
  const auto cell = [](double at, std::size_t count) {
    const double last = static_cast<double>(count - 1);
    return static_cast<std::size_t>(std::clamp(std::floor(at / kCell), 0.0, last));
  };
  for (std::size_t y = cell(pixels.low[1], rows_); y <= cell(pixels.high[1], rows_); ++y) {
    for (std::size_t x = cell(pixels.low[0], columns_); x <= cell(pixels.high[0], columns_); ++x) {
      if (!visit(y * columns_ + x)) return false;
    }
  }
  return true;
}

// If more boxes meet in a cell, no label would be readable, so the whole cell is treated as
// occupied.
constexpr std::size_t kCrowd = 16;

void SvgCanvas::occupy(const Box2& pixels) {
  for_each_cell(pixels, [&](std::size_t cell) {
    if (cells_[cell].size() < kCrowd) cells_[cell].push_back(pixels);
    return true;
  });
}

bool SvgCanvas::is_free(const Box2& pixels) const {
  return for_each_cell(pixels, [&](std::size_t cell) {
    const std::vector<Box2>& boxes = cells_[cell];
    return boxes.size() < kCrowd &&
           std::none_of(boxes.begin(), boxes.end(),
                        [&](const Box2& other) { return other.overlaps(pixels); });
  });
}

Point2 SvgCanvas::to_pixels(const Point2& world) const {
  return {kMargin + scale_ * (world[0] - origin_[0]),
          height_ - kMargin - scale_ * (world[1] - origin_[1])};
}

void SvgCanvas::add_grid() {
  const double step = round_step(70 / scale_);
  const Box2 area = sheet();
  std::string lines;
  std::string numbers;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double first = std::ceil(origin_[axis] / step);
    for (int i = 0; i < 100; ++i) {
      const double value = (first + i) * step;
      const Point2 at = to_pixels({value, value});
      if (at[axis] > area.high[axis] || at[axis] < area.low[axis]) break;
      const bool is_zero = std::fabs(value) < step / 2;
      const Point2 from = axis == 0 ? Point2{at[0], area.low[1]} : Point2{area.low[0], at[1]};
      const Point2 to = axis == 0 ? Point2{at[0], area.high[1]} : Point2{area.high[0], at[1]};
      lines += "<path d=\"M" + pixels(from) + "L" + pixels(to) + "\"" +
               (is_zero ? " stroke=\"#999\"" : "") + "/>\n";
      const Point2 text =
          axis == 0 ? Point2{at[0], area.high[1] + 16} : Point2{area.low[0] - 6, at[1] + 4};
      numbers += "<text x=\"" + pixels(text[0]) + "\" y=\"" + pixels(text[1]) +
                 "\" text-anchor=\"" + (axis == 0 ? "middle" : "end") + "\">" +
                 format_rounded(is_zero ? 0 : value) + "</text>\n";
    }
  }
  text_ += "<g stroke=\"#e2e2e2\" fill=\"none\">\n" + lines + "</g>\n";
  text_ += "<g fill=\"#777\" font-size=\"11\">\n" + numbers + "</g>\n";
}

std::optional<Box2> SvgCanvas::place_of_label(const Point2& at, double width) const {
  // All names are in the view from above; the other view only shows names that fit immediately. In
  // crowded scenes, a longer search fails.
  constexpr std::size_t kMostLost = 100;
  const double farthest = top_ > 0 || lost_names_ > kMostLost ? 30 : 130;
  const Box2 area{{4, kTitleHeight}, {width_ - 4, height_ - kNumbersHeight}};
  // Tries all sides of the point, and then places farther away.
  for (double far = 0; far < farthest; far += kFontSize + 3) {
    for (const Point2& offset : {Point2{12, -10 - far}, Point2{-12 - width, -10 - far},
                                 Point2{12, 20 + far}, Point2{-12 - width, 20 + far},
                                 Point2{-width / 2, -16 - far}, Point2{-width / 2, 26 + far}}) {
      const Point2 low{at[0] + offset[0], at[1] + offset[1] - kFontSize};
      const Box2 box{low, {low[0] + width, low[1] + kFontSize + 3}};
      const bool is_inside = box.low[0] >= area.low[0] && box.high[0] <= area.high[0] &&
                             box.low[1] >= area.low[1] && box.high[1] <= area.high[1];
      if (is_inside && is_free(box)) return box;
    }
  }
  return std::nullopt;
}

void SvgCanvas::add_label(const Point2& at, std::string_view text) {
  const double width = 0.56 * kFontSize * static_cast<double>(utf8::count_code_points(text));
  const std::optional<Box2> box = place_of_label(at, width);
  if (!box) {
    ++lost_names_;
    return;
  }
  occupy(*box);
  constexpr double kNear = 40;
  const double gap = std::max(box->low[1] - at[1], at[1] - box->high[1]);
  if (gap > kNear) {
    const Point2 end{std::clamp(at[0], box->low[0], box->high[0]),
                     at[1] > box->high[1] ? box->high[1] : box->low[1]};
    text_ += "<path d=\"M" + pixels(at) + "L" + pixels(end) + "\" stroke=\"#999\"/>\n";
  }
  text_ += "<text class=\"name\" x=\"" + pixels(box->low[0]) + "\" y=\"" +
           pixels(box->high[1] - 3) + "\">" + escape_xml(text) + "</text>\n";
}

std::string SvgCanvas::finish(std::string_view legend) {
  text_ += "<g transform=\"translate(" + pixels(kMargin) + " " + pixels(top_ + height_ + 6) +
           ")\" font-size=\"12\" fill=\"#444\">\n" + std::string(legend) + "</g>\n</svg>\n";
  return std::move(text_);
}

// Pictures of large scenes consist mostly of such numbers: writing hundredths is several times
// faster than finding the shortest text of a double.
std::string pixels(double value) {
  constexpr double kMost = 1e13;
  const double hundredths = std::round(value * 100);
  if (std::fabs(hundredths) > kMost) return format_number(hundredths / 100);
  const auto whole = static_cast<std::int64_t>(std::fabs(hundredths));
  std::string text = hundredths < 0 ? "-" : "";
  text += std::to_string(whole / 100);
  if (const std::int64_t part = whole % 100; part != 0) {
    text += '.';
    text += static_cast<char>('0' + part / 10);
    if (part % 10 != 0) text += static_cast<char>('0' + part % 10);
  }
  return text;
}

std::string pixels(const Point2& point) { return pixels(point[0]) + " " + pixels(point[1]); }

}  // namespace smurf
