// SPDX-License-Identifier: BSD-3-Clause
// Hulls of many points, and the boxes and capsules around them: of shapes whose smallest box and
// capsule are known, and of random points, which must all be inside.
#include "mesh/fitted_shapes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/numbers/vectors.hpp"
#include "mesh/convex_mesh.hpp"
#include "unit/random.hpp"

using namespace smurf;
using smurf::test::Random;

namespace {

std::vector<Vector3> corners_of_box(const Vector3& size, const Pose& X_MB) {
  std::vector<Vector3> points;
  for (unsigned i = 0; i < 8; ++i) {
    const Vector3 corner = rotate(X_MB.orientation, {(i & 1U) != 0 ? size[0] / 2 : -size[0] / 2,
                                                     (i & 2U) != 0 ? size[1] / 2 : -size[1] / 2,
                                                     (i & 4U) != 0 ? size[2] / 2 : -size[2] / 2});
    points.push_back(
        {corner[0] + X_MB.position[0], corner[1] + X_MB.position[1], corner[2] + X_MB.position[2]});
  }
  return points;
}

Pose random_pose(Random& random) {
  const auto one = [&] { return random.between(-1, 1); };
  Quaternion q{one(), one(), one(), one()};
  if (!(norm(q) > 0.1)) q = {};
  return {{one(), one(), one()}, normalized(q)};
}

Vector3 in_frame(const Pose& X_MF, const Vector3& point) {
  return rotate(inverse(X_MF).orientation, difference(point, X_MF.position));
}

/// How far the point is outside; negative inside.
double outside(const FittedBox& box, const Vector3& point) {
  const Vector3 in_box = in_frame(box.X_MB, point);
  double most = -HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::fabs(in_box[i]) - box.size[i] / 2);
  return most;
}

double outside(const FittedCapsule& capsule, const Vector3& point) {
  const auto [x, y, z] = in_frame(capsule.X_MC, point);
  const double over = std::max(0.0, std::fabs(z) - capsule.length / 2);
  return std::sqrt(x * x + y * y + over * over) - capsule.radius;
}

double outside(const ConvexMesh& hull, const Vector3& point) {
  double most = -HUGE_VAL;
  for (const HalfSpace& side : hull.sides)
    most = std::max(most, dot(side.normal, point) - side.distance);
  return most;
}

ConvexMesh hull_of(const std::vector<Vector3>& points) {
  const auto hull = convex_mesh(points);
  REQUIRE(hull);
  return *hull;
}

}  // namespace

TEST_CASE("fitted shapes: the box around a turned box is that box") {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Vector3 size{random.between(0.01, 1), random.between(0.01, 1), random.between(0.01, 1)};
    const ConvexMesh hull = hull_of(corners_of_box(size, random_pose(random)));
    const FittedBox box = fitted_box(hull);
    CHECK(hull.volume == doctest::Approx(size[0] * size[1] * size[2]).epsilon(1e-6));
    CHECK(box.volume() == doctest::Approx(hull.volume).epsilon(1e-6));
  }
}

TEST_CASE("fitted shapes: a straight box is not turned") {
  const FittedBox box = fitted_box(hull_of(corners_of_box({3, 2, 1}, {{5, 6, 7}, {}})));
  CHECK(box.X_MB == Pose{{5, 6, 7}, {}});
  CHECK(box.size == Vector3{3, 2, 1});
}

TEST_CASE("fitted shapes: the capsule around points of a turned capsule is that capsule") {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const Pose X_MC = random_pose(random);
    const double radius = random.between(0.05, 0.3);
    const double length = random.between(0.5, 1);
    std::vector<Vector3> points;
    for (const double end : {-length / 2, length / 2}) {
      for (int k = 0; k < 400; ++k) {
        Vector3 out{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
        const double reach = std::sqrt(dot(out, out));
        if (!(reach > 0.1)) continue;
        const Vector3 at{out[0] / reach * radius, out[1] / reach * radius,
                         out[2] / reach * radius + end};
        const Vector3 turned = rotate(X_MC.orientation, at);
        points.push_back({turned[0] + X_MC.position[0], turned[1] + X_MC.position[1],
                          turned[2] + X_MC.position[2]});
      }
    }
    const FittedCapsule capsule = fitted_capsule(hull_of(points));
    const double least = std::numbers::pi * radius * radius * (length + radius * 4 / 3);
    CHECK(capsule.volume() <= least * 1.02);
    for (const Vector3& point : points) CHECK(outside(capsule, point) <= 1e-6);
  }
}

TEST_CASE("fitted shapes: around points on a ball there is a ball") {
  Random random(3);
  std::vector<Vector3> points;
  for (const Vector3& corner : corners_of_box({2, 2, 2}, {})) points.push_back(corner);
  const FittedCapsule ball = fitted_capsule(hull_of(points));
  CHECK(ball.volume() <= 4.0 / 3 * std::numbers::pi * std::pow(3, 1.5) * 1.001);
}

TEST_CASE("fitted shapes: random points are inside of all shapes, and no shape is smaller than the "
          "hull") {
  Random random(4);
  for (int i = 0; i < 60; ++i) {
    const Pose X_MP = random_pose(random);
    const Vector3 size{random.between(0.01, 2), random.between(0.01, 2), random.between(0.01, 2)};
    const Vector3 far{random.between(-50, 50), random.between(-50, 50), 0};
    std::vector<Vector3> points;
    const auto count = static_cast<std::size_t>(random.between(4, 2000));
    for (std::size_t k = 0; k < count; ++k) {
      const Vector3 at = rotate(X_MP.orientation,
                                {random.between(-1, 1) * size[0], random.between(-1, 1) * size[1],
                                 random.between(-1, 1) * size[2]});
      points.push_back({at[0] + far[0], at[1] + far[1], at[2] + far[2]});
    }
    const auto hull = convex_mesh(points);
    if (!hull) continue;  // a few points may be nearly in a plane
    const FittedBox box = fitted_box(*hull);
    const FittedCapsule capsule = fitted_capsule(*hull);
    constexpr double kInside = 1e-6;
    for (const Vector3& point : points) {
      CHECK(outside(*hull, point) <= kInside);
      CHECK(outside(box, point) <= kInside);
      CHECK(outside(capsule, point) <= kInside);
    }
    CHECK(box.volume() >= hull->volume * (1 - 1e-6));
    CHECK(capsule.volume() >= hull->volume * (1 - 1e-6));
    const Box straight = box_of(points);
    const Vector3 edges = straight.size();
    CHECK(box.volume() <= edges[0] * edges[1] * edges[2] * (1 + 1e-6));
  }
}

TEST_CASE("fitted shapes: points in a plane, too few and endless ones have no hull") {
  const std::vector<Vector3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.2, 0}};
  CHECK_FALSE(convex_mesh(flat));
  CHECK_FALSE(convex_mesh(std::vector<Vector3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  CHECK_FALSE(convex_mesh({}));
  std::vector<Vector3> endless = corners_of_box({1, 1, 1}, {});
  endless[3][1] = HUGE_VAL;
  CHECK_FALSE(convex_mesh(endless));
}

TEST_CASE("fitted shapes: what two hulls share counts once") {
  const std::vector<ConvexMesh> hulls = {hull_of(corners_of_box({2, 1, 1}, {{0, 0, 0}, {}})),
                                         hull_of(corners_of_box({2, 1, 1}, {{1, 0, 0}, {}})),
                                         hull_of(corners_of_box({1, 1, 1}, {{9, 0, 0}, {}}))};
  CHECK(volume_of_union(hulls) == doctest::Approx(3 + 1).epsilon(0.005));
  CHECK(volume_of_union({}) == 0);
}
