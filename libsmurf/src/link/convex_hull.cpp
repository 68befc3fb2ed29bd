// SPDX-License-Identifier: BSD-3-Clause
#include "link/convex_hull.hpp"

#include <algorithm>
#include <cmath>

#include "base/deadline.hpp"
#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

/// Moves the point into the intersection of all half-spaces, each shrunk by `margin`. False if it
/// is not reached soon.
bool relax(Vector3& point, const ConvexHull& a, const ConvexHull& b, double margin) {
  constexpr int kMostSteps = 60;
  for (int step = 0; step < kMostSteps; ++step) {
    Deadline::look((a.sides.size() + b.sides.size()) / 16);
    const HalfSpace* worst = nullptr;
    double excess = 0;
    for (const ConvexHull* hull : {&a, &b}) {
      for (const HalfSpace& side : hull->sides) {
        const double over = dot(side.normal, point) - side.distance + margin;
        if (over <= excess) continue;
        worst = &side;
        excess = over;
      }
    }
    if (worst == nullptr) return true;
    constexpr double kFurther = 1.3;  // past the plane: the next violation is then smaller
    for (std::size_t i = 0; i < 3; ++i) point[i] -= kFurther * excess * worst->normal[i];
  }
  return false;
}

/// Whether a side of one hull shows that the other is not `least` behind it.
bool is_apart(const ConvexHull& a, const ConvexHull& b, double least) {
  return std::any_of(a.sides.begin(), a.sides.end(), [&](const HalfSpace& side) {
    return std::all_of(b.corners.begin(), b.corners.end(), [&](const Vector3& corner) {
      return dot(side.normal, corner) > side.distance - least;
    });
  });
}

}  // namespace

std::optional<ConvexHull> convex_hull(const std::vector<Vector3>& points) {
  double reach = 0;
  for (const Vector3& point : points) {
    for (const double x : point) reach = std::max(reach, std::fabs(x));
  }
  constexpr double kSinglePrecision = 4e-7;
  const auto faces = quickhull(points, kSinglePrecision * reach);
  if (!faces) return std::nullopt;
  ConvexHull hull;
  std::vector<bool> is_used(points.size());
  const Vector3 origin = points[faces->front().corners[0]];
  for (const HullFace& face : *faces) {
    hull.sides.push_back(face.side);
    const auto [a, b, c] = face.corners;
    for (const std::uint32_t corner : face.corners) is_used[corner] = true;
    hull.volume += dot(difference(points[a], origin),
                       cross(difference(points[b], origin), difference(points[c], origin))) /
                   6;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_used[i]) hull.corners.push_back(points[i]);
  }
  return hull;
}

ConvexHull moved(const ConvexHull& hull_B, const Pose& X_AB) {
  ConvexHull hull_A;
  hull_A.volume = hull_B.volume;
  hull_A.corners.reserve(hull_B.corners.size());
  hull_A.sides.reserve(hull_B.sides.size());
  const std::array<double, 9> R = to_matrix(X_AB.orientation);
  const auto turned = [&](const Vector3& v) {
    return Vector3{R[0] * v[0] + R[1] * v[1] + R[2] * v[2], R[3] * v[0] + R[4] * v[1] + R[5] * v[2],
                   R[6] * v[0] + R[7] * v[1] + R[8] * v[2]};
  };
  for (const Vector3& corner : hull_B.corners) {
    Vector3 point = turned(corner);
    for (std::size_t i = 0; i < 3; ++i) point[i] += X_AB.position[i];
    hull_A.corners.push_back(point);
  }
  for (const HalfSpace& side : hull_B.sides) {
    const Vector3 normal = turned(side.normal);
    hull_A.sides.push_back({normal, side.distance + dot(normal, X_AB.position)});
  }
  return hull_A;
}

Box box_around(const ConvexHull& hull) {
  Box box{hull.corners.front(), hull.corners.front()};
  for (const Vector3& corner : hull.corners) {
    for (std::size_t i = 0; i < 3; ++i) {
      box.low[i] = std::min(box.low[i], corner[i]);
      box.high[i] = std::max(box.high[i], corner[i]);
    }
  }
  return box;
}

double overlap_of(const ConvexHull& a, const ConvexHull& b, double least) {
  if (is_apart(a, b, least) || is_apart(b, a, least)) return 0;
  const Box one = box_around(a);
  const Box other = box_around(b);
  Vector3 point;
  for (std::size_t i = 0; i < 3; ++i) {
    point[i] = (std::max(one.low[i], other.low[i]) + std::min(one.high[i], other.high[i])) / 2;
  }
  double found = 0;
  constexpr double kGrowth = 1.25;
  for (double depth = least; relax(point, a, b, depth / 2); depth *= kGrowth) found = depth;
  return found;
}

}  // namespace smurf
