// SPDX-License-Identifier: BSD-3-Clause
#include "write/svg/svg_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "write/parts/annotated_colors.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf {
namespace {

/// Robots get these colours in turn.
constexpr std::string_view kColors[] = {"#4878a8", "#e08a3c", "#6aa84f", "#a05195",
                                        "#c0504d", "#17a2b8", "#8d6e63", "#7f8c2b"};

/// An arrow; an axis along the line of sight is a dot (its tip) or a cross (its feathers).
void add_axis(SvgCanvas& canvas, const Point2& from, const Point2& to, bool is_up,
              std::string_view color) {
  const std::string paint = " stroke=\"" + std::string(color) + "\"";
  const double length = hypotenuse(to[0] - from[0], to[1] - from[1]);
  if (length < 7) {
    canvas.add("<circle cx=\"" + pixels(from[0]) + "\" cy=\"" + pixels(from[1]) +
               "\" r=\"4.5\" fill=\"#fff\" stroke-width=\"1.5\"" + paint + "/>");
    if (is_up) {
      canvas.add("<circle cx=\"" + pixels(from[0]) + "\" cy=\"" + pixels(from[1]) +
                 "\" r=\"1.8\" fill=\"" + std::string(color) + "\"/>\n");
    } else {
      canvas.add("<path d=\"M" + pixels({from[0] - 3, from[1] - 3}) + "l6 6m-6 0l6 -6\"" + paint +
                 " stroke-width=\"1.5\"/>\n");
    }
    return;
  }
  const Point2 along{(to[0] - from[0]) / length, (to[1] - from[1]) / length};
  const double head = std::min(8.0, length / 2);
  const Point2 neck{to[0] - head * along[0], to[1] - head * along[1]};
  const Point2 side{-0.45 * head * along[1], 0.45 * head * along[0]};
  canvas.add("<path d=\"M" + pixels(from) + "L" + pixels(neck) + "\" stroke-width=\"2\"" + paint +
             "/><path d=\"M" + pixels(to) + "L" + pixels({neck[0] + side[0], neck[1] + side[1]}) +
             "L" + pixels({neck[0] - side[0], neck[1] - side[1]}) + "Z\" fill=\"" +
             std::string(color) + "\"/>\n");
}

}  // namespace

/// A distant entity must not shrink all others to a dot: entities far beyond the nearer half of the
/// scene are only indicated by an arrow.
SvgSelection::SvgSelection(const FlatScene& flat) : flat_(flat) {
  const std::size_t count = flat.instances.size();
  const auto position = [&](std::size_t i) { return flat.instances[i].X_WE->position; };
  is_far_.assign(count, false);
  std::vector<std::size_t> order;
  std::vector<double> xs, ys;
  for (std::size_t i = 0; i < count; ++i) {
    if (!has_pose(i)) continue;
    order.push_back(i);
    xs.push_back(position(i)[0]);
    ys.push_back(position(i)[1]);
  }
  if (order.size() < 3) return;
  std::sort(xs.begin(), xs.end());
  std::sort(ys.begin(), ys.end());
  const Point2 center{xs[(xs.size() - 1) / 2], ys[(ys.size() - 1) / 2]};
  const auto distance = [&](std::size_t i) {
    return hypotenuse(position(i)[0] - center[0], position(i)[1] - center[1]);
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
  constexpr double kFarFactor = 10;
  for (std::size_t i = order.size() / 2; i + 1 < order.size(); ++i) {
    if (distance(order[i + 1]) <= kFarFactor * std::max(1.0, distance(order[i]))) continue;
    for (std::size_t far = i + 1; far < order.size(); ++far) is_far_[order[far]] = true;
    return;
  }
}

SvgView::SvgView(const SceneExport& scene, const SvgSelection& selection, SvgOutlines& outlines,
                 const Pose& X_VW)
    : scene_(scene),
      selection_(selection),
      outlines_(outlines),
      X_VW_(X_VW),
      is_turned_(X_VW != Pose{}) {
  std::size_t robots = 0;
  for (std::size_t i = 0; i < count(); ++i) robots_.push_back(at(i).model ? robots++ : 0);
  collect_footprints();
  widen_to_ground();
}

void SvgView::draw(SvgCanvas& canvas) {
  canvas.add_grid();
  add_footprints(canvas);
  add_fixings(canvas);
  for (std::size_t i = 0; i < count(); ++i) {
    if (selection_.is_shown(i)) add_frame(canvas, i);
  }
  for (std::size_t i = 0; i < count(); ++i) {
    if (selection_.is_shown(i)) canvas.add_label(canvas.to_pixels(position(i)), name(i));
  }
}

Point2 SvgView::position(std::size_t i) const {
  const Vector3 p_V = in_view(*at(i).X_WE).position;
  return {p_V[0], p_V[1]};
}

std::string_view SvgView::color(std::size_t i) const {
  return at(i).model ? kColors[robots_[i] % std::size(kColors)] : "#888";
}

/// Collects the shapes to show; nearer shapes come later, to be drawn over the others.
void SvgView::collect_footprints() {
  LinkFrames frames;
  AnnotatedColors colors;
  for (std::size_t i = 0; i < count(); ++i) {
    if (!selection_.is_shown(i)) continue;
    extent_.add(position(i));
    for (PlacedShape& shape : placed_shapes(scene_, i, frames, colors)) {
      const Pose X_VS = in_view(shape.X_WS);
      const std::vector<Vector3> points = outlines_.of(shape.geometry, X_VS);
      if (points.empty()) continue;
      Footprint footprint{std::move(shape.geometry), X_VS, points.front()[2], i};
      for (const Vector3& p_V : points) {
        footprint.nearest = std::max(footprint.nearest, p_V[2]);
        if (!footprint.is_ground()) extent_.add({p_V[0], p_V[1]});
      }
      footprints_.push_back(std::move(footprint));
    }
  }
  std::stable_sort(footprints_.begin(), footprints_.end(),
                   [](const Footprint& a, const Footprint& b) { return a.nearest < b.nearest; });
}

/// The ground does not affect the extent, as long as something stands on it.
void SvgView::widen_to_ground() {
  for (const Footprint& footprint : footprints_) {
    if (extent_.size(0) + extent_.size(1) > 0) return;
    if (!footprint.is_ground()) continue;
    for (const Vector3& p_V : outlines_.of(footprint.geometry, footprint.X_VS)) {
      extent_.add({p_V[0], p_V[1]});
    }
  }
}

void SvgView::add_footprints(SvgCanvas& canvas) {
  const Box2 sheet = canvas.sheet();
  canvas.add("<clipPath id=\"" + canvas.clip() + "\"><rect x=\"" + pixels(sheet.low[0]) +
             "\" y=\"" + pixels(sheet.low[1]) + "\" width=\"" + pixels(sheet.size(0)) +
             "\" height=\"" + pixels(sheet.size(1)) + "\"/></clipPath>\n<g clip-path=\"url(#" +
             canvas.clip() +
             ")\" fill-opacity=\"0.28\" stroke-width=\"1\" stroke-opacity=\"0.8\">\n");
  for (const Footprint& footprint : footprints_) {
    std::vector<Point2> points;
    for (const Vector3& p_V : outlines_.of(footprint.geometry, footprint.X_VS)) {
      points.push_back({p_V[0], p_V[1]});
    }
    std::string path;
    for (const Point2& point : convex_hull(std::move(points))) {
      path += (path.empty() ? "M" : "L") + pixels(canvas.to_pixels(point));
    }
    const std::string style =
        footprint.is_ground() ? "fill=\"#b9a98a\" fill-opacity=\"0.15\" stroke=\"#b9a98a\""
                              : "fill=\"" + std::string(color(footprint.instance)) +
                                    "\" stroke=\"" + std::string(color(footprint.instance)) + "\"";
    canvas.add("<path d=\"" + path + "Z\" " + style + "/>\n");
  }
  canvas.add("</g>\n");
}

/// Draws a dashed line from an instance to its anchor, or a plate if it is fixed to the
/// world.
void SvgView::add_fixings(SvgCanvas& canvas) const {
  for (std::size_t i = 0; i < count(); ++i) {
    if (!selection_.is_shown(i)) continue;
    const Point2 here = canvas.to_pixels(position(i));
    if (is_fixed_to_world(at(i))) {
      canvas.add("<rect x=\"" + pixels(here[0] - 8) + "\" y=\"" + pixels(here[1] - 8) +
                 "\" width=\"16\" height=\"16\" fill=\"none\" stroke=\"#333\" "
                 "stroke-width=\"1.5\"/>\n");
    }
    if (at(i).anchor.kind != Attachment::Kind::link) continue;
    const std::size_t other = at(i).anchor.index;
    if (!selection_.is_shown(other)) continue;
    canvas.add("<path d=\"M" + pixels(here) + "L" + pixels(canvas.to_pixels(position(other))) +
               "\" stroke=\"#333\" stroke-width=\"1.2\" stroke-dasharray=\"5 4\"/>\n");
  }
}

void SvgView::add_frame(SvgCanvas& canvas, std::size_t i) const {
  constexpr double kArrow = 34;
  const Point2 origin = canvas.to_pixels(position(i));
  canvas.add("<g><title>" + escape_xml(tooltip(i)) + "</title>\n");
  Box2 taken{{origin[0] - 5, origin[1] - 5}, {origin[0] + 5, origin[1] + 5}};
  // The axis nearest to the viewer is drawn last.
  std::array<std::pair<double, std::size_t>, 3> order;
  std::array<Vector3, 3> axes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector3 unit{};
    unit[axis] = 1;
    axes[axis] = rotate(in_view(*at(i).X_WE).orientation, unit);
    order[axis] = {axes[axis][2], axis};
  }
  std::sort(order.begin(), order.end());
  for (const auto& [height, axis] : order) {
    const Point2 tip{origin[0] + kArrow * axes[axis][0], origin[1] - kArrow * axes[axis][1]};
    add_axis(canvas, origin, tip, height > 0, kAxisColors[axis]);
    taken.add(tip);
  }
  canvas.add("</g>\n");
  canvas.occupy(taken);
}

void SvgView::add_pointers(SvgCanvas& canvas) const {
  for (std::size_t i = 0; i < count(); ++i) {
    if (!selection_.has_pose(i) || selection_.is_shown(i)) continue;

    const Box2 sheet = canvas.sheet();
    const Point2 center{(sheet.low[0] + sheet.high[0]) / 2, (sheet.low[1] + sheet.high[1]) / 2};
    const Point2 target = canvas.to_pixels(position(i));
    const Point2 way{target[0] - center[0], target[1] - center[1]};
    const double reach = std::min(sheet.size(0) / 2 / std::max(std::fabs(way[0]), 1e-9),
                                  sheet.size(1) / 2 / std::max(std::fabs(way[1]), 1e-9));
    const Point2 tip{center[0] + reach * way[0], center[1] + reach * way[1]};
    const double length = hypotenuse(way[0], way[1]);
    constexpr double kArrow = 30;
    const Point2 from{tip[0] - kArrow * way[0] / length, tip[1] - kArrow * way[1] / length};
    add_axis(canvas, from, tip, true, "#666");
    canvas.add_label(from, name(i) + " (" + format_rounded(position(i)[0], 4) + ", " +
                               format_rounded(position(i)[1], 4) + ")");
  }
}

std::string SvgView::tooltip(std::size_t i) const {
  std::string text = name(i) + ": ";
  text += at(i).model ? scene_.flat.models[*at(i).model].id : at(i).type;
  if (is_fixed_to_world(at(i))) return text + ", fixed to the world";
  if (at(i).anchor.kind != Attachment::Kind::link) return text + ", free";
  return text + ", fixed to " + at(i).anchor.instance + "::" + at(i).anchor.link;
}

}  // namespace smurf
