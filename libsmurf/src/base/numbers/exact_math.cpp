// SPDX-License-Identifier: BSD-3-Clause
// The sum of two doubles as one number (T. J. Dekker, "A floating-point technique for extending the
// available precision", 1971). The compiler must not fuse a product with a sum: -ffp-contract=off.
#include "base/numbers/exact_math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace smurf {
namespace {

/// |low| is at most half of the last digit of `high`.
struct Double2 {
  double high;
  double low;
};

/// Exact, like the next two functions. Precondition: |a| >= |b|.
constexpr Double2 ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

Double2 sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

constexpr Double2 product(double a, double b) {
  constexpr double kSplit = 134217729;  // 2^27 + 1
  const auto upper_half = [](double x) {
    const double shifted = kSplit * x;
    return shifted - (shifted - x);
  };
  const double a1 = upper_half(a);
  const double a2 = a - a1;
  const double b1 = upper_half(b);
  const double b2 = b - b1;
  const double product = a * b;
  return {product, ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2};
}

Double2 operator+(const Double2& a, const Double2& b) {
  const Double2 high = sum(a.high, b.high);
  const Double2 low = sum(a.low, b.low);
  const Double2 first = ordered_sum(high.high, high.low + low.high);
  return ordered_sum(first.high, first.low + low.low);
}

/// Precondition: |a| is larger.
Double2 larger_sum(const Double2& a, const Double2& b) {
  const Double2 high = ordered_sum(a.high, b.high);
  return ordered_sum(high.high, high.low + (a.low + b.low));
}

constexpr Double2 operator-(const Double2& a) { return {-a.high, -a.low}; }

Double2 operator*(const Double2& a, const Double2& b) {
  const Double2 high = product(a.high, b.high);
  return ordered_sum(high.high, high.low + (a.high * b.low + a.low * b.high));
}

constexpr Double2 operator/(const Double2& a, double b) {
  const double quotient = a.high / b;
  const Double2 back = product(quotient, b);
  return ordered_sum(quotient, ((a.high - back.high) - back.low + a.low) / b);
}

struct SineCosine2 {
  Double2 sine;
  Double2 cosine;
};

/// The remaining terms are below the precision of a double for numbers up to 1.
constexpr std::size_t kTerms = 13;
using Coefficients = std::array<Double2, kTerms>;

/// 1/first!, -1/(first+2)!, 1/(first+4)!, ...
constexpr Coefficients alternating_factorials(int first) {
  Coefficients all{{{1, 0}}};
  for (std::size_t k = 1; k < kTerms; ++k) {
    const int n = first + 2 * static_cast<int>(k);
    all[k] = all[k - 1] / -static_cast<double>(n * (n - 1));
  }
  return all;
}

constexpr Coefficients kOfCosine = alternating_factorials(0);
constexpr Coefficients kOfSine = alternating_factorials(1);  // over the angle

/// The sum of coefficients times powers of the square, for angles up to pi/4.
Double2 series(const Double2& square, const Coefficients& all) {
  constexpr std::size_t kPrecise = 5;  // for the other terms, a double is precise enough
  double rest = 0;
  for (std::size_t k = kTerms; k-- > kPrecise;) rest = all[k].high + square.high * rest;
  Double2 value{rest, 0};
  for (std::size_t k = kPrecise; k-- > 0;) value = larger_sum(all[k], square * value);
  return value;
}

/// The angle minus the nearest multiple of a quarter turn, and that multiple.
Double2 reduced(double radians, int& quarter) {
  quarter = 0;
  if (std::fabs(radians) <= std::numbers::pi / 4) return {radians, 0};
  constexpr double kQuarter[] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54,
                                 -0x1.f1976b7ed8fbcp-110};
  const double count = std::nearbyint(radians / kQuarter[0]);
  Double2 rest{radians, 0};
  for (const double part : kQuarter) rest = rest + -product(count, part);
  quarter = static_cast<int>(std::fmod(count, 4)) & 3;
  return rest;
}

SineCosine2 sine_cosine_2(double radians) {
  int quarter = 0;
  const Double2 rest = reduced(radians, quarter);
  const Double2 square = rest * rest;
  const Double2 sine = rest * series(square, kOfSine);
  const Double2 cosine = series(square, kOfCosine);
  switch (quarter) {
  case 0: return {sine, cosine};
  case 1: return {cosine, -sine};
  case 2: return {-sine, -cosine};
  default: return {-cosine, sine};
  }
}

/// The root of a sum of squares; `scale` is the largest number.
double scaled_length(std::initializer_list<double> numbers, double scale) {
  if (scale == 0 || !std::isfinite(scale)) return scale;
  // Nearly all numbers have squares that are neither too large nor too small.
  const int exponent = scale > 1e-50 && scale < 1e50 ? 0 : std::ilogb(scale);
  Double2 squares{0, 0};
  for (const double number : numbers) {
    const double scaled = exponent == 0 ? number : std::ldexp(number, -exponent);
    squares = squares + product(scaled, scaled);
  }
  const double root = std::sqrt(squares.high);
  const Double2 rest = squares + -product(root, root);
  const double length = root + rest.high / (2 * root);
  return exponent == 0 ? length : std::ldexp(length, exponent);
}

}  // namespace

SineCosine sine_cosine(double radians) {
  // Angles with so many turns are not meant; their reduction would need more digits.
  constexpr double kMost = 1e5;
  if (!(std::fabs(radians) < kMost)) return {std::sin(radians), std::cos(radians)};
  if (std::fabs(radians) < 1e-150) return {radians, 1};  // the parts of products would underflow
  const auto [sine, cosine] = sine_cosine_2(radians);
  return {sine.high, cosine.high};
}

double arc_tangent(double y, double x) {
  const double near = std::atan2(y, x);
  const double larger = std::max(std::fabs(x), std::fabs(y));
  const bool is_exact = x == 0 || y == 0 || std::fabs(near) < 1e-150;
  if (is_exact || !std::isfinite(larger)) return near;
  const int exponent = std::ilogb(larger);
  const Double2 height{std::ldexp(y, -exponent), 0};
  const Double2 width{std::ldexp(x, -exponent), 0};
  const auto [sine, cosine] = sine_cosine_2(near);
  const Double2 across = height * cosine + -(width * sine);
  const Double2 along = width * cosine + height * sine;
  return near + across.high / along.high;
}

double hypotenuse(double x, double y) {
  return scaled_length({x, y}, std::max(std::fabs(x), std::fabs(y)));
}

double hypotenuse(double x, double y, double z) {
  return scaled_length({x, y, z}, std::max({std::fabs(x), std::fabs(y), std::fabs(z)}));
}

}  // namespace smurf
