// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/exact_math.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "unit/random.hpp"

using namespace smurf;

namespace {

constexpr int kRandom = 20000;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Whether `value` is `exact` rounded, or a neighbour if `exact` is between two doubles.
bool is_rounded(double value, long double exact) {
  const auto rounded = static_cast<double>(exact);
  if (value == rounded) return true;
  const long double step = std::fabs(static_cast<long double>(value) - rounded);
  return std::fabs(std::fabs(exact - rounded) / step - 0.5L) < 2e-3L;
}

}  // namespace

TEST_CASE("exact math: results are rounded correctly") {
  if (std::numeric_limits<long double>::digits < 64) return;  // nothing to compare with
  test::Random random(3);
  for (int i = 0; i < kRandom; ++i) {
    const double x = random.between(-4, 4) * std::pow(10, random.between(-12, 4));
    const double y = random.between(-4, 4) * std::pow(10, random.between(-3, 3));
    const double z = random.between(-4, 4);
    CAPTURE(x);
    CAPTURE(y);
    if (std::fabs(x) < 1000) {  // beyond, sinl itself is not precise enough
      REQUIRE(is_rounded(sine_cosine(x).sine, sinl(x)));
      REQUIRE(is_rounded(sine_cosine(x).cosine, cosl(x)));
    }
    REQUIRE(is_rounded(arc_tangent(y, x), atan2l(y, x)));
    REQUIRE(is_rounded(hypotenuse(x, y), hypotl(x, y)));
    REQUIRE(is_rounded(hypotenuse(x, y, z),
                       sqrtl(static_cast<long double>(x) * x + static_cast<long double>(y) * y +
                             static_cast<long double>(z) * z)));
  }
}

TEST_CASE("exact math: what is not in between") {
  CHECK(sine_cosine(0).sine == 0);
  CHECK(sine_cosine(0).cosine == 1);
  CHECK(std::signbit(sine_cosine(-0.0).sine));
  CHECK(sine_cosine(1e-200).sine == 1e-200);
  CHECK(sine_cosine(std::numbers::pi).sine == 1.2246467991473532e-16);
  CHECK(sine_cosine(std::numbers::pi / 2).cosine == 6.123233995736766e-17);
  CHECK(std::isnan(sine_cosine(kInfinity).sine));
  CHECK(arc_tangent(0, 1) == 0);
  CHECK(std::signbit(arc_tangent(-0.0, 1)));
  CHECK(arc_tangent(1, 0) == std::numbers::pi / 2);
  CHECK(arc_tangent(0, -1) == std::numbers::pi);
  CHECK(arc_tangent(1, 1) == std::numbers::pi / 4);
  CHECK(arc_tangent(1e-300, 1e-300) == std::numbers::pi / 4);
  CHECK(arc_tangent(kInfinity, 1) == std::numbers::pi / 2);
  CHECK(hypotenuse(3, 4) == 5);
  CHECK(hypotenuse(0, 0) == 0);
  CHECK(hypotenuse(std::ldexp(3, 700), std::ldexp(4, 700)) == std::ldexp(5, 700));
  CHECK(hypotenuse(3e-320, 0) == 3e-320);
  CHECK(hypotenuse(1, 2, 2) == 3);
  CHECK(hypotenuse(kInfinity, 1) == kInfinity);
}
