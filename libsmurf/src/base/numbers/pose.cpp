// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/pose.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/vectors.hpp"

namespace smurf {
namespace {

Quaternion conjugate(const Quaternion& q) { return {q.w, -q.x, -q.y, -q.z}; }

/// Exact at multiples of 90 degrees and symmetric around them: the angle is reduced in degrees,
/// where the reduction has no rounding error.
SineCosine sine_cosine_of_degrees(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  const double quarter = std::nearbyint(turn / 90.0);
  const double rest = turn - 90.0 * quarter;
  const double radians = rest * (std::numbers::pi / 180.0);
  auto [s, c] = sine_cosine(radians);
  // Half of a quarter turn: pi/4 is not a double, and for its neighbours, sine and cosine differ.
  if (std::fabs(rest) == 45) c = std::numbers::sqrt2 / 2, s = std::copysign(c, rest);
  switch ((static_cast<int>(quarter) + 4) % 4) {
  case 0: return {s, c};
  case 1: return {c, -s};
  case 2: return {-s, -c};
  default: return {-c, s};
  }
}

/// q = qz * qy * qx from the sines and cosines of the half angles.
Quaternion from_half_angles(const SineCosine& x, const SineCosine& y, const SineCosine& z) {
  return {z.cosine * y.cosine * x.cosine + z.sine * y.sine * x.sine,
          z.cosine * y.cosine * x.sine - z.sine * y.sine * x.cosine,
          z.cosine * y.sine * x.cosine + z.sine * y.cosine * x.sine,
          z.sine * y.cosine * x.cosine - z.cosine * y.sine * x.sine};
}

}  // namespace

Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return {
      a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
      a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z, a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x};
}

Vector3 rotate(const Quaternion& rotation, const Vector3& vector) {
  const Vector3 axis{rotation.x, rotation.y, rotation.z};
  Vector3 twice = cross(axis, vector);
  for (double& component : twice) component += component;
  const Vector3 further = cross(axis, twice);
  Vector3 turned;
  for (std::size_t i = 0; i < 3; ++i) turned[i] = vector[i] + rotation.w * twice[i] + further[i];
  return turned;
}

double norm(const Quaternion& q) {
  // Adding in pairs rounds less than a running sum, so normalized() reaches its fixed point sooner.
  return std::sqrt((q.x * q.x + q.z * q.z) + (q.y * q.y + q.w * q.w));
}

Quaternion normalized(const Quaternion& q) {
  Quaternion unit = q;
  // After rounding, the length is close to 1, but not exactly 1. Dividing again reaches a fixed
  // point, so poses do not change when they are written and read.
  for (int i = 0; i < 4; ++i) {
    const double length = norm(unit);
    assert(length > 0);
    if (length == 1) break;
    unit = {unit.w / length, unit.x / length, unit.y / length, unit.z / length};
  }
  double sign = 1;
  for (const double component : {unit.w, unit.x, unit.y, unit.z}) {
    if (component != 0) {
      sign = component < 0 ? -1 : 1;
      break;
    }
  }
  // Adding 0 turns -0 into 0.
  return {unit.w * sign + 0.0, unit.x * sign + 0.0, unit.y * sign + 0.0, unit.z * sign + 0.0};
}

Pose operator*(const Pose& X_AB, const Pose& X_BC) {
  const Vector3 turned = rotate(X_AB.orientation, X_BC.position);
  Pose X_AC;
  for (std::size_t i = 0; i < 3; ++i) X_AC.position[i] = X_AB.position[i] + turned[i];
  X_AC.orientation = normalized(multiply(X_AB.orientation, X_BC.orientation));
  return X_AC;
}

Pose inverse(const Pose& X_AB) {
  const Quaternion back = conjugate(X_AB.orientation);
  const Vector3 turned = rotate(back, X_AB.position);
  return {{-turned[0], -turned[1], -turned[2]}, back};
}

double angle_between(const Quaternion& a, const Quaternion& b) {
  // 2 atan2(|v|, |w|) keeps its accuracy for small angles, acos does not.
  const Quaternion difference = multiply(conjugate(a), b);
  return 2 *
         arc_tangent(hypotenuse(difference.x, difference.y, difference.z), std::fabs(difference.w));
}

Quaternion from_rpy(const Vector3& rpy) {
  if (rpy == Vector3{}) return {};  // most angles are zero, and computing sines is slow
  const auto half = [](double angle) { return sine_cosine(angle / 2); };
  return normalized(from_half_angles(half(rpy[0]), half(rpy[1]), half(rpy[2])));
}

Quaternion from_rpy_degrees(const Vector3& degrees) {
  const auto half = [](double angle) { return sine_cosine_of_degrees(angle / 2); };
  return normalized(from_half_angles(half(degrees[0]), half(degrees[1]), half(degrees[2])));
}

Vector3 to_rpy(const Quaternion& q) {
  // Compensated form: roll is computed in the frame already turned by yaw, so that nothing cancels
  // near pitch = +-90 degrees (the textbook form loses the rotation there).
  const std::array<double, 9> r = to_matrix(q);
  const double h = hypotenuse(r[0], r[3]);
  double pitch = arc_tangent(-r[6], h);
  const double yaw = h < 1e-15 ? 0 : arc_tangent(r[3], r[0]);
  const auto [s, c] = sine_cosine(yaw);
  const double roll = arc_tangent(s * r[2] - c * r[5], c * r[4] - s * r[1]);
  constexpr double kHalfPi = std::numbers::pi / 2;
  if (std::fabs(std::fabs(pitch) - kHalfPi) < 3e-16) pitch = std::copysign(kHalfPi, pitch);
  return {roll + 0.0, pitch + 0.0, yaw + 0.0};
}

Quaternion from_axis_angle(const Vector3& axis, double angle) {
  const auto [s, c] = sine_cosine(angle / 2);
  return {c, s * axis[0], s * axis[1], s * axis[2]};
}

std::array<double, 9> to_matrix(const Quaternion& q) {
  const double x = 2 * q.x;
  const double y = 2 * q.y;
  const double z = 2 * q.z;
  return {1 - (y * q.y + z * q.z), y * q.x - z * q.w,       z * q.x + y * q.w,
          y * q.x + z * q.w,       1 - (x * q.x + z * q.z), z * q.y - x * q.w,
          z * q.x - y * q.w,       z * q.y + x * q.w,       1 - (x * q.x + y * q.y)};
}

}  // namespace smurf
