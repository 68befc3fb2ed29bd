// SPDX-License-Identifier: BSD-3-Clause
#include "link/hull_contact.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

Vector3 negative(const Vector3& v) { return {-v[0], -v[1], -v[2]}; }

/// At most four points of the difference of two hulls; the newest one is the last.
class Simplex {
 public:
  void add(const Vector3& point) { points_[count_++] = point; }

  /// Keeps the part that is next to the origin, and turns `direction` from it to the origin. True
  /// if the origin is inside.
  bool reduce(Vector3& direction) {
    switch (count_) {
    case 2: line(direction); return false;
    case 3: triangle(direction); return false;
    default: return is_inside(direction);
    }
  }

 private:
  void keep(const Vector3& a, const Vector3& b) {
    points_ = {a, b};
    count_ = 2;
  }

  void line(Vector3& direction) {
    const Vector3 newest = points_[1];
    const Vector3 edge = difference(points_[0], newest);
    const Vector3 to_origin = negative(newest);
    if (dot(edge, to_origin) > 0) {
      direction = cross(cross(edge, to_origin), edge);
    } else {
      points_[0] = newest;
      count_ = 1;
      direction = to_origin;
    }
  }

  void triangle(Vector3& direction) {
    const Vector3 c = points_[0];
    const Vector3 b = points_[1];
    const Vector3 a = points_[2];
    const Vector3 ab = difference(b, a);
    const Vector3 ac = difference(c, a);
    const Vector3 normal = cross(ab, ac);
    const Vector3 to_origin = negative(a);
    if (dot(cross(normal, ac), to_origin) > 0) {
      keep(dot(ac, to_origin) > 0 ? c : b, a);
      return line(direction);
    }
    if (dot(cross(ab, normal), to_origin) > 0) {
      keep(b, a);
      return line(direction);
    }
    if (dot(normal, to_origin) > 0) {
      direction = normal;
    } else {
      points_ = {b, c, a};
      direction = negative(normal);
    }
  }

  bool is_inside(Vector3& direction) {
    const auto [d, c, b, a] = points_;
    const Vector3 to_origin = negative(a);
    const std::array<std::pair<Vector3, Vector3>, 3> sides{{{b, c}, {c, d}, {d, b}}};
    for (const auto& [first, second] : sides) {
      const Vector3 normal = cross(difference(first, a), difference(second, a));
      if (dot(normal, to_origin) <= 0) continue;
      points_ = {second, first, a};
      count_ = 3;
      triangle(direction);
      return false;
    }
    return true;
  }

  std::array<Vector3, 4> points_{};
  std::size_t count_ = 0;
};

}  // namespace

HullCorners hull_corners(std::vector<Vector3> corners) {
  HullCorners hull{.corners = std::move(corners)};
  Vector3 low = hull.corners.front();
  Vector3 high = low;
  for (const Vector3& corner : hull.corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], corner[i]);
      high[i] = std::max(high[i], corner[i]);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) hull.center[i] = (low[i] + high[i]) / 2;
  for (const Vector3& corner : hull.corners) {
    const Vector3 arm = difference(corner, hull.center);
    hull.radius = std::max(hull.radius, std::sqrt(dot(arm, arm)));
  }
  return hull;
}

PlacedHull::PlacedHull(const HullCorners& hull, const Pose& X_WH)
    : hull_(&hull),
      rotation_(to_matrix(X_WH.orientation)),
      position_(X_WH.position),
      center_((X_WH * Pose{hull.center, {}}).position) {}

Vector3 PlacedHull::farthest(const Vector3& direction, double size) const {
  const std::array<double, 9>& R = rotation_;
  const Vector3 own{R[0] * direction[0] + R[3] * direction[1] + R[6] * direction[2],
                    R[1] * direction[0] + R[4] * direction[1] + R[7] * direction[2],
                    R[2] * direction[0] + R[5] * direction[1] + R[8] * direction[2]};
  const Vector3* best = nullptr;
  double most = 0;
  for (const Vector3& corner : hull_->corners) {
    const double height = dot(corner, own);
    if (best != nullptr && height <= most) continue;
    best = &corner;
    most = height;
  }
  Vector3 point;
  for (std::size_t i = 0; i < 3; ++i) {
    const double turned = R[3 * i] * (*best)[0] + R[3 * i + 1] * (*best)[1] +
                          R[3 * i + 2] * (*best)[2] + position_[i];
    point[i] = center_[i] + size * (turned - center_[i]);
  }
  return point;
}

bool are_touching(const PlacedHull& a, const PlacedHull& b, double size, Vector3& axis) {
  constexpr int kMostSteps = 64;
  const Vector3 between = difference(a.center(), b.center());
  const double reach = size * (a.radius() + b.radius());
  if (dot(between, between) > reach * reach) return false;
  const auto farthest = [&](const Vector3& direction) {
    return difference(a.farthest(direction, size), b.farthest(negative(direction), size));
  };
  Vector3 direction = dot(axis, axis) > 0 ? axis : negative(between);
  if (dot(direction, direction) == 0) return true;  // both centres are one point
  Simplex simplex;
  Vector3 point = farthest(direction);
  if (dot(point, direction) < 0) {
    axis = direction;
    return false;
  }
  simplex.add(point);
  direction = negative(point);
  for (int step = 0; step < kMostSteps; ++step) {
    const double length = hypotenuse(direction[0], direction[1], direction[2]);
    if (!(length > 0)) return true;
    for (double& component : direction) component /= length;
    point = farthest(direction);
    if (dot(point, direction) < 0) {
      axis = direction;
      return false;
    }
    simplex.add(point);
    if (simplex.reduce(direction)) return true;
  }
  return true;
}

}  // namespace smurf
