// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/deadline.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/rotations.hpp"
#include "mesh/fitted_axes.hpp"
#include "mesh/fitted_shapes.hpp"

namespace smurf {
namespace {

using Point2 = std::array<double, 2>;

struct Circle {
  Point2 center{};
  double radius = 0;
};

double distance(const Point2& a, const Point2& b) { return hypotenuse(a[0] - b[0], a[1] - b[1]); }

Circle around(const Point2& a, const Point2& b) {
  const Point2 center{(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
  return {center, std::max(distance(center, a), distance(center, b))};
}

/// The circle through three points; if they are on a line, around the outer two.
Circle around(const Point2& a, const Point2& b, const Point2& c) {
  const Point2 to_b{b[0] - a[0], b[1] - a[1]};
  const Point2 to_c{c[0] - a[0], c[1] - a[1]};
  const double area = 2 * (to_b[0] * to_c[1] - to_b[1] * to_c[0]);
  const double square_b = to_b[0] * to_b[0] + to_b[1] * to_b[1];
  const double square_c = to_c[0] * to_c[0] + to_c[1] * to_c[1];
  constexpr double kLine = 1e-12;  // of the squares
  if (std::fabs(area) <= kLine * (square_b + square_c)) {
    Circle circle = around(a, b);
    for (const Circle& other : {around(a, c), around(b, c)}) {
      if (other.radius > circle.radius) circle = other;
    }
    return circle;
  }
  const Point2 center{a[0] + (to_c[1] * square_b - to_b[1] * square_c) / area,
                      a[1] + (to_b[0] * square_c - to_c[0] * square_b) / area};
  return {center, std::max({distance(center, a), distance(center, b), distance(center, c)})};
}

bool is_outside(const Circle& circle, const Point2& point) {
  constexpr double kRounding = 1 + 1e-12;
  return distance(circle.center, point) > circle.radius * kRounding;
}

/// The smallest circle around the points: Welzl's algorithm in its iterative form. The order of the
/// points should be arbitrary.
Circle smallest_circle(const std::vector<Point2>& points) {
  Circle circle{points.front(), 0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!is_outside(circle, points[i])) continue;
    circle = {points[i], 0};
    for (std::size_t k = 0; k < i; ++k) {
      if (!is_outside(circle, points[k])) continue;
      circle = around(points[i], points[k]);
      Deadline::look(k / 64 + 1);
      for (std::size_t m = 0; m < k; ++m) {
        if (is_outside(circle, points[m])) circle = around(points[i], points[k], points[m]);
      }
    }
  }
  for (const Point2& point : points)
    circle.radius = std::max(circle.radius, distance(circle.center, point));
  return circle;
}

/// Points in an arbitrary order, the same in every run.
void shuffle(std::vector<Vector3>& points) {
  std::uint64_t state = 88172645463325252ULL;
  for (std::size_t i = points.size(); i > 1; --i) {
    state ^= state << 13U;  // xorshift, Marsaglia 2003
    state ^= state >> 7U;
    state ^= state << 17U;
    std::swap(points[i - 1], points[state % i]);
  }
}

/// A point seen along the axis of a capsule.
struct Seen {
  double height = 0;  ///< along the axis
  double radius = 0;  ///< from the axis
};

/// The part of the axis that the centres of balls of this radius must cover, so that each point is
/// in one; `high` may be below `low`.
struct Reach {
  double low = HUGE_VAL, high = -HUGE_VAL;
};
Reach reach_of(const std::vector<Seen>& points, double radius) {
  Reach reach;
  for (const Seen& point : points) {
    const double room = std::sqrt(std::max(0.0, radius * radius - point.radius * point.radius));
    reach.low = std::min(reach.low, point.height + room);
    reach.high = std::max(reach.high, point.height - room);
  }
  return reach;
}

double volume_of(double radius, double length) {
  return std::numbers::pi * radius * radius * (length + radius * 4 / 3);
}

/// The best capsule along a direction. A larger radius than that of the circle around the shadow
/// can make it shorter.
FittedCapsule capsule_along(const std::vector<Vector3>& points, const Vector3& direction) {
  const Axes axes = axes_along(direction);
  std::vector<Point2> shadow;
  shadow.reserve(points.size());
  for (const Vector3& point : points) shadow.push_back({dot(axes[0], point), dot(axes[1], point)});
  const Circle circle = smallest_circle(shadow);
  std::vector<Seen> seen;
  seen.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    seen.push_back({dot(direction, points[i]), distance(circle.center, shadow[i])});
  FittedCapsule best;
  double least = HUGE_VAL;
  constexpr int kSteps = 24;
  constexpr double kLargest = 0.5;  // more than the radius of the circle
  for (int step = 0; step <= kSteps; ++step) {
    const double radius = circle.radius * (1 + kLargest * step / kSteps);
    const Reach reach = reach_of(seen, radius);
    const double length = std::max(0.0, reach.high - reach.low);
    Deadline::look(points.size() / 64 + 1);
    if (volume_of(radius, length) >= least) continue;
    least = volume_of(radius, length);
    best.radius = radius;
    best.length = length;
    best.X_MC = {along(axes, {circle.center[0], circle.center[1], (reach.high + reach.low) / 2}),
                 from_axes(axes[0], axes[1], axes[2])};
    if (length == 0) break;  // a larger ball is no better
  }
  return best;
}

/// A ball around the points: from the middle of the box, the centre is pulled to the farthest point
/// in smaller and smaller steps (Badoiu and Clarkson 2003).
FittedCapsule ball_around(const std::vector<Vector3>& points, const Vector3& middle) {
  Vector3 center = middle;
  const auto farthest = [&] {
    return std::max_element(points.begin(), points.end(), [&](const Vector3& a, const Vector3& b) {
      const Vector3 to_a = difference(a, center);
      const Vector3 to_b = difference(b, center);
      return dot(to_a, to_a) < dot(to_b, to_b);
    });
  };
  constexpr int kSteps = 1000;
  for (int step = 1; step <= kSteps; ++step) {
    Deadline::look(points.size() / 64 + 1);
    const Vector3 to = difference(*farthest(), center);
    for (std::size_t i = 0; i < 3; ++i) center[i] += to[i] / (step + 1);
  }
  const Vector3 to = difference(*farthest(), center);
  FittedCapsule ball;
  ball.X_MC.position = center;
  ball.radius = std::sqrt(dot(to, to));
  return ball;
}

}  // namespace

double FittedCapsule::volume() const { return volume_of(radius, length); }

FittedCapsule fitted_capsule(const ConvexMesh& hull) {
  std::vector<Vector3> points = hull.points;
  shuffle(points);
  const Axes box = [&] {
    const Quaternion turned = fitted_box(hull).X_MB.orientation;
    return Axes{rotate(turned, {1, 0, 0}), rotate(turned, {0, 1, 0}), rotate(turned, {0, 0, 1})};
  }();
  FittedCapsule best = ball_around(points, box_of(points).center());
  Vector3 direction{0, 0, 1};
  const auto is_better = [&](const Vector3& other) {
    const FittedCapsule capsule = capsule_along(points, unit(other));
    constexpr double kWorthTurning = 1 - 1e-6;
    if (!(capsule.volume() < kWorthTurning * best.volume())) return false;
    best = capsule;
    direction = unit(other);
    return true;
  };
  for (const Vector3& start :
       {Vector3{0, 0, 1}, Vector3{0, 1, 0}, Vector3{1, 0, 0}, box[0], box[1], box[2]})
    is_better(start);
  constexpr double kFirstTurn = 0.2;  // about 11 degrees
  constexpr double kLastTurn = 0.002;
  constexpr int kMostTurns = 200;
  int turns = 0;
  for (double size = kFirstTurn; size > kLastTurn && turns < kMostTurns;) {
    const Axes axes = axes_along(direction);
    bool has_improved = false;
    for (const Vector3& to :
         {Vector3{size, 0, 1}, Vector3{-size, 0, 1}, Vector3{0, size, 1}, Vector3{0, -size, 1}}) {
      ++turns;
      has_improved = is_better(along(axes, to));
      if (has_improved) break;
    }
    if (!has_improved) size /= 2;
  }
  // The rounding errors of the text of the pose.
  constexpr double kRounding = 1 + 1e-12;
  best.radius *= kRounding;
  return best;
}

}  // namespace smurf
