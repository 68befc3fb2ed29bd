// SPDX-License-Identifier: BSD-3-Clause
#include "lint/rigid_shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

using Point2 = std::array<double, 2>;

double turn(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The corners of the convex hull of points in a plane, in their order around it.
std::vector<Point2> convex_polygon(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  std::vector<Point2> hull;
  for (int pass = 0; pass < 2; ++pass) {
    const std::size_t first = hull.size();
    for (const Point2& point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    if (!hull.empty()) hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double distance_to_edge(const Point2& a, const Point2& b) {
  const Point2 edge{b[0] - a[0], b[1] - a[1]};
  const double square = edge[0] * edge[0] + edge[1] * edge[1];
  const double at =
      square > 0 ? std::clamp(-(a[0] * edge[0] + a[1] * edge[1]) / square, 0.0, 1.0) : 0;
  return hypotenuse(a[0] + at * edge[0], a[1] + at * edge[1], 0);
}

std::array<Vector3, 8> corners_of(const Box& box) {
  std::array<Vector3, 8> corners{};
  for (unsigned i = 0; i < 8; ++i) {
    corners[i] = {(i & 1U) != 0 ? box.high[0] : box.low[0],
                  (i & 2U) != 0 ? box.high[1] : box.low[1],
                  (i & 4U) != 0 ? box.high[2] : box.low[2]};
  }
  return corners;
}

void add(const LinkedModel& model, const Pose& X_RL, const urdf::Origin& origin,
         const urdf::Geometry& geometry, RigidShape& shape) {
  const std::optional<Box> box = bounding_box(model, geometry);
  const bool is_placed = (origin.xyz || !origin.xyz.written) && (origin.rpy || !origin.rpy.written);
  if (!box || !is_placed) {
    shape.is_known = false;
    return;
  }
  const Pose X = X_RL * urdf::to_pose(origin);
  for (const Vector3& corner : corners_of(*box)) {
    const Vector3 turned = rotate(X.orientation, corner);
    const Vector3 point{X.position[0] + turned[0], X.position[1] + turned[1],
                        X.position[2] + turned[2]};
    shape.points.push_back(point);
    const Box here{point, point};
    shape.box = shape.box ? united(*shape.box, here) : here;
  }
}

}  // namespace

std::vector<RigidShape> rigid_shapes(const LinkedModel& model,
                                     const std::vector<std::optional<Pose>>& poses,
                                     const std::vector<std::size_t>& body) {
  constexpr std::size_t kMostShapes = 2000;  // robots have fewer
  std::size_t count = 0;
  for (const urdf::Link& link : model.robot->links) {
    count += link.visuals.size() + link.collisions.size();
  }
  if (count > kMostShapes || poses.size() != body.size()) return {};
  std::vector<RigidShape> shapes(body.size());
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (!poses[i]) continue;
    const urdf::Link& link = model.robot->links[i];
    RigidShape& shape = shapes[body[i]];
    shape.has_collision = shape.has_collision || !link.collisions.empty();
    for (const urdf::Visual& one : link.visuals)
      add(model, *poses[i], one.origin, one.geometry, shape);
    for (const urdf::Collision& one : link.collisions) {
      add(model, *poses[i], one.origin, one.geometry, shape);
    }
  }
  return shapes;
}

double diagonal_of(const Box& box) {
  const Vector3 size = box.size();
  return hypotenuse(size[0], size[1], size[2]);
}

double distance_to(const Box& box, const Vector3& point) {
  Vector3 distance{};
  for (std::size_t i = 0; i < 3; ++i) {
    distance[i] = std::max({0.0, box.low[i] - point[i], point[i] - box.high[i]});
  }
  return hypotenuse(distance[0], distance[1], distance[2]);
}

double distance_from_line(const Vector3& point, const Vector3& direction,
                          const std::vector<Vector3>& points) {
  const Vector3 away = std::fabs(direction[0]) < 0.5 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  Vector3 u = cross(direction, away);
  const double length = hypotenuse(u[0], u[1], u[2]);
  for (double& x : u) x /= length;
  const Vector3 v = cross(direction, u);
  std::vector<Point2> seen;
  seen.reserve(points.size());
  for (const Vector3& one : points) {
    const Vector3 d = difference(one, point);
    seen.push_back({dot(d, u), dot(d, v)});
  }
  const std::vector<Point2> hull = convex_polygon(std::move(seen));
  bool is_inside = hull.size() >= 3;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point2& a = hull[i];
    const Point2& b = hull[(i + 1) % hull.size()];
    is_inside = is_inside && turn(a, b, {0, 0}) >= 0;
    least = std::min(least, distance_to_edge(a, b));
  }
  return is_inside ? 0 : least;
}

}  // namespace smurf
