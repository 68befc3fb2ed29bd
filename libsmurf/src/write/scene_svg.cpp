// SPDX-License-Identifier: BSD-3-Clause
// A picture of the scene from above: footprints, axes, names, and what is fixed to what.
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>
#include <vector>

#include "base/edits.hpp"
#include "base/exact_math.hpp"
#include "base/numbers.hpp"
#include "base/path.hpp"
#include "write/annotated_colors.hpp"
#include "write/placed_shapes.hpp"
#include "write/svg_canvas.hpp"

namespace smurf {
namespace {

constexpr std::string_view kAxisColors[] = {"#d62828", "#2a9134", "#1d5fd1"};
constexpr std::string_view kModelColors[] = {"#4878a8", "#e08a3c", "#6aa84f", "#a05195",
                                             "#c0504d", "#17a2b8", "#8d6e63", "#7f8c2b"};

constexpr int kSegments = 24;  // of a circle

/// Where the polygons of balls begin, as seen from above: along the shape's axis, or, when that
/// stands upright, along its x axis.
double start_angle(const Quaternion& orientation) {
  constexpr double kUpright = 1e-6;
  const Vector3 z = rotate(orientation, {0, 0, 1});
  const Vector3 along = hypotenuse(z[0], z[1]) > kUpright ? z : rotate(orientation, {1, 0, 0});
  return arc_tangent(along[1], along[0]);
}

using Circle = std::array<Point2, kSegments>;  ///< points around the origin

const Circle& unit_circle() {
  static const Circle circle = [] {
    Circle points;
    for (int i = 0; i < kSegments; ++i) {
      const auto [sine, cosine] = sine_cosine(2 * std::numbers::pi * i / kSegments);
      points[static_cast<std::size_t>(i)] = {cosine, sine};
    }
    return points;
  }();
  return circle;
}

Circle circle(double radius, double start) {
  const auto [sine, cosine] = sine_cosine(start);
  const double along = radius * cosine;
  const double aside = radius * sine;
  Circle points = unit_circle();
  for (Point2& p : points) p = {along * p[0] - aside * p[1], aside * p[0] + along * p[1]};
  return points;
}

/// Balls of one radius on the axis of a shape: circles from above, whose points are as high as the
/// top.
void add_balls(const Pose& X_WS, double radius, std::initializer_list<double> heights,
               std::vector<Vector3>& points) {
  const Circle around = circle(radius, start_angle(X_WS.orientation));
  for (const double z : heights) {
    const Vector3 center = (X_WS * Pose{{0, 0, z}, {}}).position;
    for (const Point2& p : around) {
      points.push_back({center[0] + p[0], center[1] + p[1], center[2] + radius});
    }
  }
}

/// Points in the frame of a shape whose hull is its outline; round things as polygons.
std::vector<Vector3> corners(const FlatGeometry& geometry) {
  std::vector<Vector3> points;
  const auto add_corners = [&](const Vector3& size) {
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        for (const double z : {-0.5, 0.5}) {
          points.push_back({x * size[0], y * size[1], z * size[2]});
        }
      }
    }
  };
  if (const auto* plane = std::get_if<FlatPlane>(&geometry)) {
    add_corners({plane->length, plane->width, 0});
  } else if (const auto* box = std::get_if<FlatBox>(&geometry)) {
    add_corners(box->size);
  } else if (const auto* map = std::get_if<FlatHeightmap>(&geometry)) {
    add_corners({map->length, map->width, 0});
  } else if (const auto* cylinder = std::get_if<FlatCylinder>(&geometry)) {
    const Circle around = circle(cylinder->radius, 0);
    for (const double end : {0.5, -0.5}) {
      for (const Point2& p : around) points.push_back({p[0], p[1], end * cylinder->length});
    }
  }
  return points;  // nothing is known of a mesh: files are not read here
}

/// Points in the world whose hull, from above, is the shape's outline.
std::vector<Vector3> outline(const PlacedShape& shape) {
  std::vector<Vector3> points;
  if (const auto* sphere = std::get_if<FlatSphere>(&shape.geometry)) {
    add_balls(shape.X_WS, sphere->radius, {0}, points);
  } else if (const auto* capsule = std::get_if<FlatCapsule>(&shape.geometry)) {
    const double end = capsule->length / 2;
    add_balls(shape.X_WS, capsule->radius, {end, -end}, points);
  } else {
    points = corners(shape.geometry);
    for (Vector3& point : points) point = (shape.X_WS * Pose{point, {}}).position;
  }
  return points;
}

Point2 from_above(const Vector3& point) { return {point[0], point[1]}; }

/// One shape seen from above. There may be hundreds of thousands: outlines are not kept.
struct Footprint {
  PlacedShape shape;
  double top = 0;  ///< m; what is higher is drawn later
  std::size_t instance = 0;

  bool is_ground() const { return std::holds_alternative<FlatPlane>(shape.geometry); }
};

class TopView {
 public:
  explicit TopView(const SceneExport& scene) : scene_(scene) {}

  std::string run() {
    find_far_instances();
    collect_footprints();
    widen_to_ground();
    SvgCanvas canvas(extent_,
                     std::string(path::file_name(scene_.flat.scene)) + " from above, metres");
    canvas.add_grid();
    add_footprints(canvas);
    add_fixings(canvas);
    for (std::size_t i = 0; i < count(); ++i) {
      if (is_shown(i)) add_frame(canvas, i);
    }
    for (std::size_t i = 0; i < count(); ++i) {
      if (is_shown(i)) canvas.add_label(canvas.to_pixels(position(i)), name(i));
    }
    for (std::size_t i = 0; i < count(); ++i) {
      if (has_pose(i) && is_far_[i]) add_pointer(canvas, i);
    }
    return canvas.finish(legend());
  }

 private:
  std::size_t count() const { return scene_.flat.instances.size(); }
  const FlatInstance& at(std::size_t i) const { return scene_.flat.instances[i]; }
  bool has_pose(std::size_t i) const { return at(i).X_WE.has_value(); }
  bool is_shown(std::size_t i) const { return has_pose(i) && !is_far_[i]; }
  Point2 position(std::size_t i) const { return from_above(at(i).X_WE->position); }
  const std::string& name(std::size_t i) const { return at(i).path; }

  std::string_view color(std::size_t i) const {
    if (!at(i).model) return "#888";
    return kModelColors[*at(i).model % std::size(kModelColors)];
  }

  /// Of what is shown, the higher ones later.
  void collect_footprints() {
    LinkFrames frames;
    AnnotatedColors colors;
    for (std::size_t i = 0; i < count(); ++i) {
      if (!is_shown(i)) continue;
      extent_.add(position(i));
      for (PlacedShape& shape : placed_shapes(scene_, i, frames, colors)) {
        const std::vector<Vector3> points = outline(shape);
        if (points.empty()) continue;
        Footprint footprint{std::move(shape), points.front()[2], i};
        for (const Vector3& p_W : points) {
          footprint.top = std::max(footprint.top, p_W[2]);
          if (!footprint.is_ground()) extent_.add(from_above(p_W));
        }
        footprints_.push_back(std::move(footprint));
      }
    }
    std::stable_sort(footprints_.begin(), footprints_.end(),
                     [](const Footprint& a, const Footprint& b) { return a.top < b.top; });
  }

  /// The ground does not decide what is worth looking at, as long as something stands on it.
  void widen_to_ground() {
    for (const Footprint& footprint : footprints_) {
      if (extent_.size(0) + extent_.size(1) > 0) return;
      if (!footprint.is_ground()) continue;
      for (const Vector3& p_W : outline(footprint.shape)) extent_.add(from_above(p_W));
    }
  }

  /// One entity far away must not shrink everything else to a dot: whatever is far beyond the
  /// nearer half of the scene is only indicated by an arrow.
  void find_far_instances() {
    is_far_.assign(count(), false);
    std::vector<std::size_t> order;
    std::vector<double> xs, ys;
    for (std::size_t i = 0; i < count(); ++i) {
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

  void add_footprints(SvgCanvas& canvas) const {
    const Box2 sheet = canvas.sheet();
    canvas.add("<clipPath id=\"sheet\"><rect x=\"" + pixels(sheet.low[0]) + "\" y=\"" +
               pixels(sheet.low[1]) + "\" width=\"" + pixels(sheet.size(0)) + "\" height=\"" +
               pixels(sheet.size(1)) +
               "\"/></clipPath>\n<g clip-path=\"url(#sheet)\" "
               "fill-opacity=\"0.28\" stroke-width=\"1\" stroke-opacity=\"0.8\">\n");
    for (const Footprint& footprint : footprints_) {
      std::vector<Point2> points;
      for (const Vector3& p_W : outline(footprint.shape)) points.push_back(from_above(p_W));
      std::string path;
      for (const Point2& point : convex_hull(std::move(points))) {
        path += (path.empty() ? "M" : "L") + pixels(canvas.to_pixels(point));
      }
      const std::string style = footprint.is_ground()
                                    ? "fill=\"#b9a98a\" fill-opacity=\"0.15\" stroke=\"#b9a98a\""
                                    : "fill=\"" + std::string(color(footprint.instance)) +
                                          "\" stroke=\"" + std::string(color(footprint.instance)) +
                                          "\"";
      canvas.add("<path d=\"" + path + "Z\" " + style + "/>\n");
    }
    canvas.add("</g>\n");
  }

  /// A dashed line to whatever an instance is fixed to; what is fixed to the world stands on a
  /// plate.
  void add_fixings(SvgCanvas& canvas) const {
    for (std::size_t i = 0; i < count(); ++i) {
      if (!is_shown(i)) continue;
      const Point2 here = canvas.to_pixels(position(i));
      if (at(i).anchor.kind == Attachment::Kind::world) {
        canvas.add("<rect x=\"" + pixels(here[0] - 8) + "\" y=\"" + pixels(here[1] - 8) +
                   "\" width=\"16\" height=\"16\" fill=\"none\" stroke=\"#333\" "
                   "stroke-width=\"1.5\"/>\n");
      }
      if (at(i).anchor.kind != Attachment::Kind::link) continue;
      const Instance& source = scene_.scene.instances[i];
      const std::size_t other = to_size(source.placement.anchor.instance);
      if (!is_shown(other)) continue;
      canvas.add("<path d=\"M" + pixels(here) + "L" + pixels(canvas.to_pixels(position(other))) +
                 "\" stroke=\"#333\" stroke-width=\"1.2\" stroke-dasharray=\"5 4\"/>\n");
    }
  }

  void add_frame(SvgCanvas& canvas, std::size_t i) const {
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
      axes[axis] = rotate(at(i).X_WE->orientation, unit);
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

  /// An arrow; an axis along the line of sight is a dot (its tip) or a cross (its feathers).
  static void add_axis(SvgCanvas& canvas, const Point2& from, const Point2& to, bool is_up,
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

  /// At the border, towards an instance that is too far away to be on the sheet.
  void add_pointer(SvgCanvas& canvas, std::size_t i) const {
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

  std::string tooltip(std::size_t i) const {
    std::string text = name(i) + ": ";
    text += at(i).model ? scene_.flat.models[*at(i).model].id : at(i).type;
    switch (at(i).anchor.kind) {
    case Attachment::Kind::none: return text + ", free";
    case Attachment::Kind::world: return text + ", fixed to the world";
    case Attachment::Kind::link: break;
    }
    return text + ", fixed to " + at(i).anchor.instance + "::" + at(i).anchor.link;
  }

  /// Only what is on the sheet is explained.
  std::string legend() const {
    std::string text;
    double x = 0;
    const auto add = [&](const std::string& glyph, std::string_view words) {
      text += "<g transform=\"translate(" + pixels(x) + " 0)\">" + glyph + "<text x=\"26\">" +
              std::string(words) + "</text></g>\n";
      x += 44 + 6.6 * static_cast<double>(words.size());
    };
    constexpr std::string_view kNames[] = {"x", "y", "z"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      add("<path d=\"M2 -4h18\" stroke-width=\"3\" stroke=\"" + std::string(kAxisColors[axis]) +
              "\"/>",
          kNames[axis]);
    }
    add("<circle cx=\"12\" cy=\"-4\" r=\"4.5\" fill=\"none\" stroke=\"#444\"/>"
        "<circle cx=\"12\" cy=\"-4\" r=\"1.8\"/>",
        "axis towards you");
    const auto is_fixed_to = [&](Attachment::Kind kind) {
      return std::any_of(
          scene_.flat.instances.begin(), scene_.flat.instances.end(),
          [&](const FlatInstance& instance) { return instance.anchor.kind == kind; });
    };
    if (is_fixed_to(Attachment::Kind::world)) {
      add("<rect x=\"5\" y=\"-11\" width=\"14\" height=\"14\" fill=\"none\" stroke=\"#333\"/>",
          "fixed to the world");
    }
    if (is_fixed_to(Attachment::Kind::link)) {
      add("<path d=\"M0 -4h22\" stroke=\"#333\" stroke-dasharray=\"5 4\"/>", "fixed to each other");
    }
    if (has_meshes()) add("", "meshes are not drawn");
    return text;
  }

  bool has_meshes() const {
    for (const FlatInstance& instance : scene_.flat.instances) {
      if (instance.model && !scene_.flat.models[*instance.model].resources.empty()) return true;
    }
    return false;
  }

  const SceneExport& scene_;
  std::vector<bool> is_far_;
  std::vector<Footprint> footprints_;
  Box2 extent_;  ///< what has to be on the sheet; m
};

std::string write(const SceneExport& scene) { return TopView(scene).run(); }

}  // namespace

extern constinit const SceneFormat scene_svg{.name = "svg",
                                             .help = "a picture from above, with axes and names",
                                             .write = write,
                                             .repeats_models = true};

}  // namespace smurf
