// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/deadline.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/rotations.hpp"
#include "mesh/fitted_axes.hpp"
#include "mesh/fitted_shapes.hpp"

namespace smurf {
namespace {

using Point2 = std::array<double, 2>;

double turn_of(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The convex polygon around the points, turning left: Andrew's monotone chain.
std::vector<Point2> polygon_around(std::vector<Point2> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Point2> chain;
  const auto add = [&](const Point2& point, std::size_t least) {
    while (chain.size() >= least && turn_of(chain[chain.size() - 2], chain.back(), point) <= 0)
      chain.pop_back();
    chain.push_back(point);
  };
  for (const Point2& point : points) add(point, 2);
  const std::size_t lower = chain.size() + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
  chain.pop_back();
  return chain;
}

/// The direction of an edge of the smallest rectangle around the polygon, which lies along one of
/// its edges.
Point2 side_of_rectangle(const std::vector<Point2>& polygon) {
  Point2 best{1, 0};
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2& from = polygon[i];
    const Point2& to = polygon[(i + 1) % polygon.size()];
    const double length = hypotenuse(to[0] - from[0], to[1] - from[1]);
    if (!(length > 0)) continue;
    const Point2 side{(to[0] - from[0]) / length, (to[1] - from[1]) / length};
    double low = HUGE_VAL;
    double high = -HUGE_VAL;
    double height = 0;
    Deadline::look(polygon.size() / 32 + 1);
    for (const Point2& point : polygon) {
      const double at = side[0] * point[0] + side[1] * point[1];
      low = std::min(low, at);
      high = std::max(high, at);
      height = std::max(height, turn_of(from, to, point) / length);
    }
    if ((high - low) * height >= least) continue;
    least = (high - low) * height;
    best = side;
  }
  return best;
}

FittedBox box_along(const ConvexMesh& hull, const Axes& axes) {
  Vector3 low{HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vector3 high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Vector3& point : hull.points) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], dot(axes[i], point));
      high[i] = std::max(high[i], dot(axes[i], point));
    }
  }
  FittedBox box;
  Vector3 middle{};
  for (std::size_t i = 0; i < 3; ++i) {
    middle[i] = (low[i] + high[i]) / 2;
    box.size[i] = high[i] - low[i];
  }
  box.X_MB = {along(axes, middle), from_axes(axes[0], axes[1], axes[2])};
  return box;
}

/// The normals of the largest faces of the hull; faces in one plane count once.
std::vector<Vector3> face_normals(const ConvexMesh& hull) {
  struct Plane {
    Vector3 normal{};
    double area = 0;
  };
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < hull.triangles.size(); ++i) {
    const auto [a, b, c] = hull.triangles[i];
    const Vector3 area = cross(difference(hull.points[b], hull.points[a]),
                               difference(hull.points[c], hull.points[a]));
    planes.push_back({hull.sides[i].normal, std::sqrt(dot(area, area))});
  }
  std::sort(planes.begin(), planes.end(),
            [](const Plane& a, const Plane& b) { return a.area > b.area; });
  constexpr std::size_t kMost = 300;
  constexpr double kSame = 1 - 1e-9;  // of the cosine; opposite faces give the same box
  std::vector<Vector3> normals;
  for (const Plane& plane : planes) {
    if (normals.size() == kMost) break;
    const bool is_known = std::any_of(normals.begin(), normals.end(), [&](const Vector3& known) {
      return std::fabs(dot(known, plane.normal)) > kSame;
    });
    if (!is_known) normals.push_back(plane.normal);
  }
  return normals;
}

}  // namespace

Axes axes_along(const Vector3& direction) {
  // The coordinate axis that is farthest from it.
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::fabs(direction[i]) < std::fabs(direction[least])) least = i;
  }
  Vector3 other{};
  other[least] = 1;
  const Vector3 first = unit(cross(other, direction));
  return {first, cross(direction, first), direction};
}

FittedBox fitted_box(const ConvexMesh& hull) {
  FittedBox best = box_along(hull, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  constexpr double kWorthTurning = 1 - 1e-6;  // rounding errors would turn a box that is straight
  for (const Vector3& normal : face_normals(hull)) {
    const Axes plane = axes_along(normal);
    std::vector<Point2> shadow;
    shadow.reserve(hull.points.size());
    for (const Vector3& point : hull.points)
      shadow.push_back({dot(plane[0], point), dot(plane[1], point)});
    const Point2 side = side_of_rectangle(polygon_around(std::move(shadow)));
    const Vector3 first = unit(along(plane, {side[0], side[1], 0}));
    const FittedBox box = box_along(hull, {first, cross(normal, first), normal});
    if (box.volume() < kWorthTurning * best.volume()) best = box;
  }
  return best;
}

}  // namespace smurf
