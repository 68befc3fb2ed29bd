// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/pose.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "unit/random.hpp"

using namespace smurf;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kHalfRoot = std::numbers::sqrt2 / 2;

double distance(const Vector3& a, const Vector3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace

TEST_CASE("pose: angles to a quaternion and back") {
  MESSAGE("seed " << test::seed());
  test::Random random;
  double worst = 0;
  for (const double off :
       {1.0, 1e-1, 1e-2, 1e-4, 1e-7, 1e-8, 1e-9, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 0.0}) {
    for (int i = 0; i < 2000; ++i) {
      const double pitch = (i % 2 == 0 ? 1 : -1) * (kPi / 2 - off);
      const Vector3 rpy{random.between(-kPi, kPi), pitch, random.between(-kPi, kPi)};
      const Quaternion q = from_rpy(rpy);
      worst = std::max(worst, angle_between(q, from_rpy(to_rpy(q))));
    }
  }
  for (int i = 0; i < 20000; ++i) {
    const Quaternion q = normalized({random.between(-1, 1), random.between(-1, 1),
                                     random.between(-1, 1), random.between(-1, 1)});
    worst = std::max(worst, angle_between(q, from_rpy(to_rpy(q))));
  }
  CAPTURE(worst);
  CHECK(worst < 1e-14);
}

TEST_CASE("pose: angles away from the lock come back as numbers") {
  test::Random random;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 rpy{random.between(-kPi, kPi), random.between(-1.5, 1.5),
                      random.between(-kPi, kPi)};
    worst = std::max(worst, distance(to_rpy(from_rpy(rpy)), rpy));
  }
  CAPTURE(worst);
  CHECK(worst < 1e-13);
}

TEST_CASE("pose: gimbal lock has a plain text") {
  const Vector3 down = to_rpy(normalized({0.7071, 0, -0.7071, 0}));
  CHECK(down == Vector3{0, -kPi / 2, 0});
  const Vector3 up = to_rpy(from_rpy({0.25, kPi / 2, 0}));
  CHECK(up[1] == kPi / 2);
  CHECK(up[2] == 0);
  CHECK(up[0] == doctest::Approx(0.25).epsilon(1e-14));
}

TEST_CASE("pose: multiples of 90 degrees are exact") {
  for (int x = -8; x <= 8; ++x) {
    for (int y = -8; y <= 8; ++y) {
      for (int z = -8; z <= 8; ++z) {
        const Quaternion q = from_rpy_degrees({x * 90.0, y * 90.0, z * 90.0});
        bool exact = true;
        for (const double component : {q.w, q.x, q.y, q.z}) {
          const double size = std::fabs(component);
          exact = exact && (size == 0 || size == 0.5 || size == kHalfRoot || size == 1);
          exact = exact && !(component == 0 && std::signbit(component));
        }
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(z);
        if (!exact) CHECK(exact);
        // Whole turns change nothing.
        CHECK(from_rpy_degrees({x * 90.0 + 720, y * 90.0, z * 90.0 - 720}) == q);
        CHECK(angle_between(q, from_rpy({x * kPi / 2, y * kPi / 2, z * kPi / 2})) < 1e-14);
      }
    }
  }
  CHECK(from_rpy_degrees({0, 0, 90}) == Quaternion{kHalfRoot, 0, 0, kHalfRoot});
  CHECK(from_rpy_degrees({180, 0, 0}) == Quaternion{0, 1, 0, 0});
  CHECK(from_rpy_degrees({0, 0, 360}) == Quaternion{});
}

TEST_CASE("pose: other degrees") {
  MESSAGE("seed " << test::seed());
  test::Random random;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vector3 degrees{random.between(-720, 720), random.between(-720, 720),
                          random.between(-720, 720)};
    Vector3 radians = degrees;
    for (double& angle : radians) angle *= kPi / 180;
    worst = std::max(worst, angle_between(from_rpy_degrees(degrees), from_rpy(radians)));
  }
  CAPTURE(worst);
  CHECK(worst < 1e-14);
  // The documented scene: rotation [1.5, 20, 0].
  const Quaternion eve = from_rpy_degrees({1.5, 20, 0});
  CHECK(eve.w == doctest::Approx(0.984723382).epsilon(1e-9));
  CHECK(eve.x == doctest::Approx(0.012890735).epsilon(1e-7));
  CHECK(eve.y == doctest::Approx(0.173633301).epsilon(1e-8));
  CHECK(eve.z == doctest::Approx(-0.002272984).epsilon(1e-6));
}

TEST_CASE("pose: canonical sign and length") {
  CHECK(normalized({-2, 0, 0, 0}) == Quaternion{});
  CHECK(normalized({0, -3, 0, 0}) == Quaternion{0, 1, 0, 0});
  CHECK(normalized({0, 0, 0, -1}) == Quaternion{0, 0, 0, 1});
  CHECK(!std::signbit(normalized({-1, 0, 0, 0}).x));
  CHECK(norm(normalized({1, 2, 3, 4})) == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("pose: the algebra of transforms") {
  test::Random random;
  const auto any = [&] {
    return Pose{{random.between(-5, 5), random.between(-5, 5), random.between(-5, 5)},
                from_rpy({random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)})};
  };
  const auto differ = [](const Pose& a, const Pose& b) {
    return std::max(distance(a.position, b.position), angle_between(a.orientation, b.orientation));
  };
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose a = any();
    const Pose b = any();
    const Pose c = any();
    worst = std::max({worst, differ((a * b) * c, a * (b * c)), differ(a * inverse(a), Pose{}),
                      differ(inverse(a * b), inverse(b) * inverse(a)), differ(a * Pose{}, a)});
  }
  CAPTURE(worst);
  CHECK(worst < 1e-13);
}

TEST_CASE("pose: rotations of vectors") {
  CHECK(distance(rotate(from_rpy_degrees({0, 0, 90}), {1, 0, 0}), {0, 1, 0}) < 1e-15);
  CHECK(distance(rotate(from_rpy_degrees({0, 90, 0}), {1, 0, 0}), {0, 0, -1}) < 1e-15);
  CHECK(distance(rotate(from_rpy_degrees({90, 0, 0}), {0, 1, 0}), {0, 0, 1}) < 1e-15);
  // Roll first, yaw last: x goes to y, then up.
  CHECK(distance(rotate(from_rpy({0, 0, kPi / 2}), {1, 0, 0}), {0, 1, 0}) < 1e-15);
  CHECK(distance(rotate(from_rpy({kPi / 2, 0, kPi / 2}), {0, 1, 0}), {0, 0, 1}) < 1e-15);
  CHECK(angle_between(from_axis_angle({0, 0, 1}, 0.3), from_rpy({0, 0, 0.3})) < 1e-15);
  const std::array<double, 9> m = to_matrix(from_rpy({0, 0, kPi / 2}));
  CHECK(m[3] == doctest::Approx(1));
  CHECK(m[1] == doctest::Approx(-1));
}

TEST_CASE("pose: small angles are told apart") {
  CHECK(angle_between({}, {}) == 0);
  CHECK(angle_between({}, from_rpy({1e-12, 0, 0})) == doctest::Approx(1e-12));
  CHECK(angle_between({1, 0, 0, 0}, {-1, 0, 0, 0}) == 0);
  CHECK(angle_between({}, {0, 1, 0, 0}) == doctest::Approx(kPi));
}
