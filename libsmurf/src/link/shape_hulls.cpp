// SPDX-License-Identifier: BSD-3-Clause
#include "link/shape_hulls.hpp"

#include <algorithm>
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

Points corners_of_cylinder(double radius, double length) {
  Points points;
  for (std::size_t corner = 0; corner < kCorners; ++corner) {
    points.push_back(on_circle(corner, radius, -length / 2));
    points.push_back(on_circle(corner, radius, length / 2));
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

bool are_positive(std::initializer_list<double> sizes) {
  return std::all_of(sizes.begin(), sizes.end(),
                     [](double size) { return size > 0 && std::isfinite(size); });
}

/// Empty if the size is unknown or not positive.
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
  if (const auto* tube = std::get_if<urdf::Cylinder>(&shape)) {
    const double radius = tube->radius.value_or(0);
    const double length = tube->length.value_or(0);
    return are_positive({radius, length}) ? corners_of_cylinder(radius, length) : Points();
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
