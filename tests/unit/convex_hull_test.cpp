// SPDX-License-Identifier: BSD-3-Clause
// Convex hulls: of shapes with a known volume, of random points, and what is no solid.
#include "link/convex_hull.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "base/numbers/vectors.hpp"
#include "link/hull_contact.hpp"
#include "link/shape_hulls.hpp"
#include "mesh/outer_points.hpp"
#include "mesh/quickhull.hpp"
#include "unit/random.hpp"

using namespace smurf;
using smurf::test::Random;

namespace {

std::vector<Vector3> corners_of_box(const Vector3& low, const Vector3& high) {
  std::vector<Vector3> points;
  for (unsigned i = 0; i < 8; ++i) {
    points.push_back({(i & 1U) != 0 ? high[0] : low[0], (i & 2U) != 0 ? high[1] : low[1],
                      (i & 4U) != 0 ? high[2] : low[2]});
  }
  return points;
}

Vector3 random_point(Random& random, double reach) {
  return {random.between(-reach, reach), random.between(-reach, reach),
          random.between(-reach, reach)};
}

Vector3 on_sphere(Random& random) {
  while (true) {
    Vector3 point = random_point(random, 1);
    const double length = std::sqrt(dot(point, point));
    if (length > 1 || length < 0.1) continue;
    for (double& x : point) x /= length;
    return point;
  }
}

}  // namespace

TEST_CASE("convex hull: a box has its volume, whatever lies in it") {
  Random random;
  for (int i = 0; i < 200; ++i) {
    const Vector3 size{random.between(0.01, 3), random.between(0.01, 3), random.between(0.01, 3)};
    std::vector<Vector3> points = corners_of_box({}, size);
    for (std::size_t k = random.below(60); k > 0; --k) {
      points.push_back({size[0] * random.between(0, 1), size[1] * random.between(0, 1),
                        random.one_in(2) ? 0 : size[2] * random.between(0, 1)});
    }
    const auto hull = convex_hull(points);
    REQUIRE(hull);
    const double volume = size[0] * size[1] * size[2];
    CHECK(std::fabs(hull->volume - volume) < 1e-5 * volume);
    CHECK(hull->corners.size() >= 8);
  }
}

TEST_CASE("convex hull: no point is outside, and a ball is nearly full") {
  Random random;
  for (int i = 0; i < 60; ++i) {
    std::vector<Vector3> points;
    const bool is_ball = i % 2 == 0;
    for (std::size_t k = 0; k < 250; ++k) {
      points.push_back(is_ball ? on_sphere(random) : random_point(random, 1));
    }
    const auto hull = convex_hull(points);
    REQUIRE(hull);
    for (const HalfSpace& side : hull->sides) {
      for (const Vector3& point : points) CHECK(dot(side.normal, point) < side.distance + 2e-6);
    }
    // The Euler characteristic of a closed surface of triangles.
    CHECK(hull->sides.size() == 2 * hull->corners.size() - 4);
    if (is_ball) CHECK(hull->volume > 0.9 * 4.18879);
    if (is_ball) CHECK(hull->volume < 4.18879);
  }
}

TEST_CASE("quickhull: many points in one plane or on one line, rounded to millimetres") {
  for (int count = 3; count < 60; ++count) {
    std::vector<Vector3> points;
    const Pose X{{0.7, -0.2, 0}, from_rpy({0, 0.3 + count, 0})};
    for (int i = 0; i < count; ++i) {
      const double angle = 6.283185307179586 * i / count;
      for (const double z : {-0.1, 0.3}) {
        Vector3 point =
            (X * Pose{{0.05 * std::cos(angle), 0.05 * std::sin(angle), z}, {}}).position;
        for (double& x : point) x = std::round(1000 * x) / 1000;
        points.push_back(point);
      }
    }
    for (const double tolerance : {1e-10, 1e-7}) {
      CAPTURE(count);
      const auto faces = quickhull(points, tolerance);
      REQUIRE(faces);
      std::set<std::uint32_t> corners;
      for (const HullFace& face : *faces) {
        corners.insert(face.corners.begin(), face.corners.end());
        for (const Vector3& point : points)
          CHECK(dot(face.side.normal, point) < face.side.distance + 1e-6);
      }
      CHECK(faces->size() == 2 * corners.size() - 4);
    }
  }
}

TEST_CASE("convex hull: flat, few and infinite points have none") {
  CHECK(!convex_hull({}));
  CHECK(!convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  CHECK(!convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 0}}));
  CHECK(!convex_hull({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}}));
  CHECK(!convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::nan("")}}));
  CHECK(!convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, HUGE_VAL}}));
  CHECK(!convex_hull(std::vector<Vector3>(100, Vector3{1, 2, 3})));
}

TEST_CASE("convex hull: the overlap of boxes is never more than it is, and found if it is deep") {
  constexpr double kLeast = 0.01;
  Random random;
  for (int i = 0; i < 500; ++i) {
    const Vector3 low = random_point(random, 1);
    const Vector3 other = random_point(random, 1);
    Vector3 high = low;
    Vector3 other_high = other;
    double depth = HUGE_VAL;  // the least length of a shift along an axis that frees them
    for (std::size_t k = 0; k < 3; ++k) {
      high[k] += random.between(0.1, 1);
      other_high[k] += random.between(0.1, 1);
      depth = std::min({depth, high[k] - other[k], other_high[k] - low[k]});
    }
    const double found = overlap_of(*convex_hull(corners_of_box(low, high)),
                                    *convex_hull(corners_of_box(other, other_high)), kLeast);
    CAPTURE(depth);
    CHECK(found <= std::max(depth, 0.0) + 1e-9);
    if (depth > 2 * kLeast) CHECK(found >= kLeast);
  }
}

TEST_CASE("convex hull: moving it changes neither its volume nor an overlap") {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const auto a = convex_hull(corners_of_box({0, 0, 0}, {1, 0.5, 0.3}));
    const auto b = convex_hull(corners_of_box({0.9, 0.1, 0.1}, {2, 0.4, 0.2}));
    const Pose X{random_point(random, 2), from_rpy(random_point(random, 3))};
    const double before = overlap_of(*a, *b, 0.01);
    CHECK(before > 0);
    CHECK(std::fabs(overlap_of(moved(*a, X), moved(*b, X), 0.01) - before) < 0.05);
    CHECK(moved(*a, X).volume == a->volume);
  }
}

TEST_CASE("convex hull: boxes and cylinders are what a search among their corners gives") {
  Random random;
  const LinkedModel model;
  for (int i = 0; i < 50; ++i) {
    const Vector3 size{random.between(0.01, 3), random.between(0.01, 3), random.between(0.01, 3)};
    urdf::Geometry geometry;
    const bool is_box = i % 2 == 0;
    if (is_box) {
      geometry.shape = urdf::Box{{std::optional(size), Span{}}};
    } else {
      geometry.shape =
          urdf::Cylinder{{std::optional(size[0]), Span{}}, {std::optional(size[2]), Span{}}};
    }
    const auto hull = hull_of(model, geometry);
    REQUIRE(hull);
    CHECK(hull->corners.size() == (is_box ? 8 : 32));
    CHECK(hull->sides.size() == (is_box ? 6 : 18));
    const auto searched = convex_hull(hull->corners);
    REQUIRE(searched);
    CHECK(hull->volume == doctest::Approx(searched->volume));
    for (const HalfSpace& side : hull->sides) {
      double farthest = -HUGE_VAL;
      for (const Vector3& corner : hull->corners) {
        farthest = std::max(farthest, dot(side.normal, corner));
      }
      CHECK(farthest == doctest::Approx(side.distance));
      CHECK(dot(side.normal, side.normal) == doctest::Approx(1));
    }
    const auto other = convex_hull(corners_of_box(random_point(random, 1), {2, 2, 2}));
    CHECK((overlap_of(*hull, *other, 0.01) > 0) == (overlap_of(*searched, *other, 0.01) > 0));
  }
  CHECK(!hull_of(model, {.shape = urdf::Box{{std::optional(Vector3{1, 0, 1}), Span{}}}}));
}

TEST_CASE("outer points: all of a small mesh, and the outermost of a large one") {
  Random random;
  OuterPoints few;
  few.add({1, 2, 3}, {4, 5, 6}, {7, 8, 9});
  CHECK(few.take() == std::vector<OuterPoints::Point>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}});

  OuterPoints many;
  double highest = -HUGE_VAL;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 first = random_point(random, 1);
    highest = std::max(highest, first[2]);
    many.add(first, random_point(random, 0.5), random_point(random, 0.5));
  }
  const std::vector<OuterPoints::Point> kept = many.take();
  CHECK(kept.size() <= OuterPoints::kMostKept + 16);
  CHECK(kept.size() > OuterPoints::kMostKept / 2);
  const auto top = std::max_element(kept.begin(), kept.end(),
                                    [](const auto& a, const auto& b) { return a[2] < b[2]; });
  CHECK((*top)[2] == static_cast<float>(highest));
}

TEST_CASE("hull contact: apart along an axis, or with room in both") {
  Random random(20261129);
  int apart = 0;
  int together = 0;
  for (int round = 0; round < 2000; ++round) {
    std::vector<Vector3> points;
    for (int i = 0; i < 12; ++i) points.push_back(random_point(random, 1));
    const auto one = convex_hull(points);
    for (Vector3& point : points) point = random_point(random, 1);
    const auto other = convex_hull(points);
    REQUIRE(one);
    REQUIRE(other);
    const Pose X_WA{random_point(random, 1), from_axis_angle(on_sphere(random), 1)};
    const Pose X_WB{random_point(random, 1.5), from_axis_angle(on_sphere(random), 2)};
    const HullCorners a = hull_corners(one->corners);
    const HullCorners b = hull_corners(other->corners);
    const PlacedHull placed(a, X_WA);
    const PlacedHull other_placed(b, X_WB);
    Vector3 axis{};
    if (are_touching(placed, other_placed, 0.98, axis)) {
      ++together;
      const auto separates = [&](const Vector3& way) {
        const Vector3 back{-way[0], -way[1], -way[2]};
        return dot(placed.farthest(way, 0.98), way) < dot(other_placed.farthest(back, 0.98), way);
      };
      for (const HalfSpace& side : moved(*one, X_WA).sides) CHECK(!separates(side.normal));
      for (const HalfSpace& side : moved(*other, X_WB).sides) CHECK(!separates(side.normal));
      for (int i = 0; i < 100; ++i) CHECK(!separates(on_sphere(random)));
    } else if (!are_touching(placed, other_placed, 1, axis) && dot(axis, axis) > 0) {
      ++apart;
      CHECK(!are_touching(placed, other_placed, 1, axis));  // asks the axis first
      const Vector3 back{-axis[0], -axis[1], -axis[2]};
      CHECK(dot(placed.farthest(axis, 1), axis) < dot(other_placed.farthest(back, 1), axis));
    }
  }
  CHECK(together > 300);
  CHECK(apart > 300);
}
