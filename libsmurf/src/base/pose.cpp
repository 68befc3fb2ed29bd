// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/pose.hpp"

#include <Eigen/Geometry>
#include <cassert>
#include <cmath>
#include <numbers>

namespace smurf {
namespace {

Eigen::Quaterniond to_eigen(const Quaternion& q) { return {q.w, q.x, q.y, q.z}; }
Quaternion from_eigen(const Eigen::Quaterniond& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Eigen::Vector3d to_eigen(const Vector3& v) { return {v[0], v[1], v[2]}; }

struct SinCos {
  double sin;
  double cos;
};

/// Exact at multiples of 90 degrees and symmetric around them: the angle is reduced in degrees,
/// where the reduction has no rounding error.
SinCos sin_cos_degrees(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  const double quarter = std::nearbyint(turn / 90.0);
  const double rest = turn - 90.0 * quarter;
  const double radians = rest * (std::numbers::pi / 180.0);
  double s = std::sin(radians);
  double c = std::cos(radians);
  // Half of a quarter turn: libm's sine and cosine of pi/4 differ in the last bit.
  if (std::fabs(rest) == 45) c = std::numbers::sqrt2 / 2, s = std::copysign(c, rest);
  switch ((static_cast<int>(quarter) + 4) % 4) {
  case 0: return {s, c};
  case 1: return {c, -s};
  case 2: return {-s, -c};
  default: return {-c, s};
  }
}

/// q = qz * qy * qx from the sines and cosines of the half angles.
Quaternion from_half_angles(const SinCos& x, const SinCos& y, const SinCos& z) {
  return {
      z.cos * y.cos * x.cos + z.sin * y.sin * x.sin, z.cos * y.cos * x.sin - z.sin * y.sin * x.cos,
      z.cos * y.sin * x.cos + z.sin * y.cos * x.sin, z.sin * y.cos * x.cos - z.cos * y.sin * x.sin};
}

}  // namespace

Quaternion multiply(const Quaternion& a, const Quaternion& b) {
  return from_eigen(to_eigen(a) * to_eigen(b));
}

Vector3 rotate(const Quaternion& rotation, const Vector3& vector) {
  const Eigen::Vector3d result = to_eigen(rotation) * to_eigen(vector);
  return {result.x(), result.y(), result.z()};
}

double norm(const Quaternion& q) { return to_eigen(q).norm(); }

Quaternion normalized(const Quaternion& q) {
  Quaternion unit = q;
  // Rounding leaves a length next to 1; dividing again finds a fixed point, so that poses that are
  // written and read back stay as they are.
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
  const Quaternion back = from_eigen(to_eigen(X_AB.orientation).conjugate());
  const Vector3 turned = rotate(back, X_AB.position);
  return {{-turned[0], -turned[1], -turned[2]}, back};
}

double angle_between(const Quaternion& a, const Quaternion& b) {
  // 2 atan2(|v|, |w|) keeps its accuracy for small angles, acos does not.
  const Eigen::Quaterniond difference = to_eigen(a).conjugate() * to_eigen(b);
  return 2 * std::atan2(difference.vec().norm(), std::fabs(difference.w()));
}

Quaternion from_rpy(const Vector3& rpy) {
  if (rpy == Vector3{}) return {};  // most are zero, and sines are dear
  const auto half = [](double angle) { return SinCos{std::sin(angle / 2), std::cos(angle / 2)}; };
  return normalized(from_half_angles(half(rpy[0]), half(rpy[1]), half(rpy[2])));
}

Quaternion from_rpy_degrees(const Vector3& degrees) {
  const auto half = [](double angle) { return sin_cos_degrees(angle / 2); };
  return normalized(from_half_angles(half(degrees[0]), half(degrees[1]), half(degrees[2])));
}

Vector3 to_rpy(const Quaternion& q) {
  // Compensated form: roll is computed in the frame already turned by yaw, so that nothing cancels
  // near pitch = +-90 degrees (the textbook form loses the rotation there).
  const std::array<double, 9> r = to_matrix(q);
  const double h = std::hypot(r[0], r[3]);
  double pitch = std::atan2(-r[6], h);
  const double yaw = h < 1e-15 ? 0 : std::atan2(r[3], r[0]);
  const double s = std::sin(yaw);
  const double c = std::cos(yaw);
  const double roll = std::atan2(s * r[2] - c * r[5], c * r[4] - s * r[1]);
  constexpr double kHalfPi = std::numbers::pi / 2;
  if (std::fabs(std::fabs(pitch) - kHalfPi) < 3e-16) pitch = std::copysign(kHalfPi, pitch);
  return {roll + 0.0, pitch + 0.0, yaw + 0.0};
}

Quaternion from_axis_angle(const Vector3& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis[0], s * axis[1], s * axis[2]};
}

std::array<double, 9> to_matrix(const Quaternion& q) {
  const Eigen::Matrix3d m = to_eigen(q).toRotationMatrix();
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

}  // namespace smurf
