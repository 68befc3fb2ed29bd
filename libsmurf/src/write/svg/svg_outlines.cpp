// SPDX-License-Identifier: BSD-3-Clause
#include "write/svg/svg_outlines.hpp"

#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/vectors.hpp"
#include "write/svg/svg_canvas.hpp"

namespace smurf {
namespace {

constexpr int kSegments = 24;  // of a circle

/// Where the polygons of balls begin, as seen by the viewer: along the shape's axis or, if that
/// points at the viewer, along its x axis.
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

/// Adds balls of one radius on the axis of a shape as circles, at the depth of their nearest point.
void add_balls(const Pose& X_VS, double radius, std::initializer_list<double> heights,
               std::vector<Vector3>& points) {
  const Circle around = circle(radius, start_angle(X_VS.orientation));
  for (const double z : heights) {
    const Vector3 center = (X_VS * Pose{{0, 0, z}, {}}).position;
    for (const Point2& p : around) {
      points.push_back({center[0] + p[0], center[1] + p[1], center[2] + radius});
    }
  }
}

/// Points in the frame of a shape whose hull is its outline; round shapes become polygons.
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
  return points;
}

/// Directions spread evenly (a spiral of the golden angle), and those of the axes.
std::vector<Vector3> directions() {
  constexpr std::size_t kDirections = 200;
  constexpr double kGoldenAngle = 2.399963229728653;
  std::vector<Vector3> all{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double z = 1 - (2.0 * static_cast<double>(i) + 1) / kDirections;
    const auto [sine, cosine] = sine_cosine(kGoldenAngle * static_cast<double>(i));
    const double across = std::sqrt(1 - z * z);
    all.push_back({across * cosine, across * sine, z});
  }
  return all;
}

/// The outermost points of a mesh. Their hull is nearly that of the mesh.
std::vector<Vector3> outermost(const MeshTriangles& mesh) {
  std::vector<Vector3> points;
  if (mesh.points.empty()) return points;
  const auto at = [&](std::size_t i) {
    const auto& [x, y, z] = mesh.points[i];
    return Vector3{x, y, z};
  };
  std::vector<bool> is_chosen(mesh.points.size());
  for (const Vector3& direction : directions()) {
    std::size_t farthest = 0;
    double reach = dot(direction, at(0));
    for (std::size_t i = 1; i < mesh.points.size(); ++i) {
      const double distance = dot(direction, at(i));
      if (distance <= reach) continue;
      reach = distance;
      farthest = i;
    }
    if (!is_chosen[farthest]) points.push_back(at(farthest));
    is_chosen[farthest] = true;
  }
  return points;
}

}  // namespace

std::vector<Vector3> SvgOutlines::of(const FlatGeometry& geometry, const Pose& X_VS) {
  std::vector<Vector3> points;
  if (const auto* sphere = std::get_if<FlatSphere>(&geometry)) {
    add_balls(X_VS, sphere->radius, {0}, points);
    return points;
  }
  if (const auto* capsule = std::get_if<FlatCapsule>(&geometry)) {
    const double end = capsule->length / 2;
    add_balls(X_VS, capsule->radius, {end, -end}, points);
    return points;
  }
  if (const auto* mesh = std::get_if<FlatMesh>(&geometry)) {
    points = points_of(mesh->file);
    for (Vector3& point : points) {
      for (std::size_t i = 0; i < 3; ++i) point[i] *= mesh->scale[i];
    }
  } else {
    points = corners(geometry);
  }
  for (Vector3& point : points) point = (X_VS * Pose{point, {}}).position;
  return points;
}

const std::vector<Vector3>& SvgOutlines::points_of(const std::string& file) {
  static const std::vector<Vector3> none;
  // Further meshes are too small to be recognised, and would make the picture large.
  constexpr std::size_t kMostDrawn = 20'000;
  if (!scene_.meshes.triangles || drawn_ >= kMostDrawn) {
    lacks_meshes_ = true;
    return none;
  }
  const std::string& name = files_.first_name(file);
  const auto [known, is_new] = meshes_.try_emplace(name);
  if (is_new) known->second = outermost(scene_.meshes.triangles(name, TexturePoints::ignored));
  if (known->second.empty()) lacks_meshes_ = true;
  ++drawn_;
  return known->second;
}

}  // namespace smurf
