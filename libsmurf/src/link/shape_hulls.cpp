// SPDX-License-Identifier: BSD-3-Clause
#include "link/shape_hulls.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/vectors.hpp"
#include "link/shape_solids.hpp"

namespace smurf {
namespace {

using Points = std::vector<Vector3>;

/// Corners of a circle, on which the points of a round shape lie.
constexpr std::size_t kCorners = 16;
Vector3 on_circle(std::size_t corner, double radius, double z) {
  constexpr double kFullTurn = 6.283185307179586;
  const double angle = kFullTurn * static_cast<double>(corner) / kCorners;
  const auto [sine, cosine] = sine_cosine(angle);
  return {radius * cosine, radius * sine, z};
}

Points corners_of_box(const Vector3& size) {
  Points points;
  for (unsigned corner = 0; corner < 8; ++corner) {
    points.push_back({(corner & 1U) != 0 ? size[0] / 2 : -size[0] / 2,
                      (corner & 2U) != 0 ? size[1] / 2 : -size[1] / 2,
                      (corner & 4U) != 0 ? size[2] / 2 : -size[2] / 2});
  }
  return points;
}

/// A ball whose halves are `length` apart.
Points corners_of_capsule(double radius, double length) {
  Points points = {{0, 0, radius + length / 2}, {0, 0, -radius - length / 2}};
  constexpr double kRows[] = {0, 0.5, 0.8660254037844386};  // sines of 0, 30 and 60 degrees
  for (const double row : kRows) {
    const double around = radius * std::sqrt(1 - row * row);
    for (std::size_t corner = 0; corner < kCorners; ++corner) {
      points.push_back(on_circle(corner, around, radius * row + length / 2));
      points.push_back(on_circle(corner, around, -radius * row - length / 2));
    }
  }
  return points;
}

Points points_of_mesh(const LinkedModel& model, const urdf::Mesh& mesh) {
  Points points;
  const MeshFacts* facts = find_facts(model, mesh);
  if (facts == nullptr || (mesh.scale.written && !mesh.scale)) return points;
  Vector3 scale = mesh.scale.value_or({1, 1, 1});
  for (double& factor : scale) factor *= facts->unit_meters.value_or(1);
  for (const auto& point : facts->outer) {
    points.push_back({point[0] * scale[0], point[1] * scale[1], point[2] * scale[2]});
  }
  return points;
}

/// The upright prism on a ring of corners that turns left, seen from above: the hull of a box or a
/// cylinder, without a search for its sides.
ConvexHull prism(const std::vector<std::array<double, 2>>& ring, double height) {
  ConvexHull hull;
  double area = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto [x, y] = ring[i];
    const auto [next_x, next_y] = ring[(i + 1) % ring.size()];
    hull.corners.push_back({x, y, -height / 2});
    hull.corners.push_back({x, y, height / 2});
    const double length = hypotenuse(next_x - x, next_y - y);
    const Vector3 normal{(next_y - y) / length, (x - next_x) / length, 0};
    hull.sides.push_back({normal, normal[0] * x + normal[1] * y});
    area += (x * next_y - y * next_x) / 2;
  }
  hull.sides.push_back({{0, 0, 1}, height / 2});
  hull.sides.push_back({{0, 0, -1}, height / 2});
  hull.volume = area * height;
  return hull;
}

bool are_positive(std::initializer_list<double> sizes) {
  return std::all_of(sizes.begin(), sizes.end(),
                     [](double size) { return size > 0 && std::isfinite(size); });
}

/// Of shapes other than cylinders. Empty if the size is unknown or not positive.
Points points_of(const LinkedModel& model, const urdf::Shape& shape) {
  if (const auto* mesh = std::get_if<urdf::Mesh>(&shape)) return points_of_mesh(model, *mesh);
  if (const auto* box = std::get_if<urdf::Box>(&shape)) {
    const Vector3 size = box->size.value_or({0, 0, 0});
    return are_positive({size[0], size[1], size[2]}) ? corners_of_box(size) : Points();
  }
  if (const auto* ball = std::get_if<urdf::Sphere>(&shape)) {
    const double radius = ball->radius.value_or(0);
    return are_positive({radius}) ? corners_of_capsule(radius, 0) : Points();
  }
  if (const auto* pill = std::get_if<urdf::Capsule>(&shape)) {
    const double radius = pill->radius.value_or(0);
    const double length = pill->length.value_or(0);
    return are_positive({radius, length}) ? corners_of_capsule(radius, length) : Points();
  }
  return {};
}

}  // namespace

std::optional<ConvexHull> hull_of(const LinkedModel& model, const urdf::Geometry& geometry) {
  if (const auto* box = std::get_if<urdf::Box>(&geometry.shape)) {
    const auto [x, y, z] = box->size.value_or({0, 0, 0});
    if (!are_positive({x, y, z})) return std::nullopt;
    return prism({{-x / 2, -y / 2}, {x / 2, -y / 2}, {x / 2, y / 2}, {-x / 2, y / 2}}, z);
  }
  if (const auto* tube = std::get_if<urdf::Cylinder>(&geometry.shape)) {
    const double radius = tube->radius.value_or(0);
    const double length = tube->length.value_or(0);
    if (!are_positive({radius, length})) return std::nullopt;
    std::vector<std::array<double, 2>> ring;
    for (std::size_t corner = 0; corner < kCorners; ++corner) {
      const Vector3 point = on_circle(corner, radius, 0);
      ring.push_back({point[0], point[1]});
    }
    return prism(ring, length);
  }
  return convex_hull(points_of(model, geometry.shape));
}

double hull_ratio(const LinkedModel& model, const urdf::Geometry& geometry) {
  const std::optional<Solid> solid = solid_of(model, geometry);
  if (!solid) return 0;
  const std::optional<ConvexHull> hull = hull_of(model, geometry);
  return hull ? hull->volume / solid->volume : 0;
}

std::optional<double> reach_of(const LinkedModel& model, const urdf::Geometry& geometry,
                               const Vector3& direction) {
  const double across = hypotenuse(direction[0], direction[1]);
  const double along = std::fabs(direction[2]);
  const urdf::Shape& shape = geometry.shape;
  if (const auto* ball = std::get_if<urdf::Sphere>(&shape)) {
    return ball->radius ? std::optional(*ball->radius) : std::nullopt;
  }
  if (const auto* tube = std::get_if<urdf::Cylinder>(&shape)) {
    if (!tube->radius || !tube->length) return std::nullopt;
    return *tube->radius * across + *tube->length / 2 * along;
  }
  if (const auto* pill = std::get_if<urdf::Capsule>(&shape)) {
    if (!pill->radius || !pill->length) return std::nullopt;
    return *pill->radius + *pill->length / 2 * along;
  }
  std::optional<double> farthest;
  for (const Vector3& point : points_of(model, shape)) {
    const double distance = dot(point, direction);
    if (!farthest || distance > *farthest) farthest = distance;
  }
  return farthest;
}

}  // namespace smurf
