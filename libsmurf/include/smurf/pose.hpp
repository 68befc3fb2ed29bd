// SPDX-License-Identifier: BSD-3-Clause
// Rigid transforms. X_AB is the pose of frame B expressed in frame A: p_A = X_AB * p_B.
#pragma once

#include <array>

namespace smurf {

using Vector3 = std::array<double, 3>;

/// Rotation as a quaternion with named components; unit length unless stated otherwise.
struct Quaternion {
  double w = 1;
  double x = 0;
  double y = 0;
  double z = 0;
  friend bool operator==(const Quaternion&, const Quaternion&) = default;
};

/// Position in metres and a unit quaternion.
struct Pose {
  Vector3 position{0, 0, 0};
  Quaternion orientation;
  friend bool operator==(const Pose&, const Pose&) = default;
};

/// X_AC = X_AB * X_BC. The result is normalised.
Pose operator*(const Pose& X_AB, const Pose& X_BC);
Pose inverse(const Pose& X_AB);
Vector3 rotate(const Quaternion& rotation, const Vector3& vector);
Quaternion multiply(const Quaternion& a, const Quaternion& b);
double norm(const Quaternion& q);
/// Unit length, and the first non-zero component of (w, x, y, z) positive. Precondition: norm(q) >
/// 0.
Quaternion normalized(const Quaternion& q);
/// Angle of the rotation between two unit quaternions, radians in [0, pi].
double angle_between(const Quaternion& a, const Quaternion& b);

/// Fixed-axis x, then y, then z (URDF rpy): R = Rz(yaw) Ry(pitch) Rx(roll); radians.
Quaternion from_rpy(const Vector3& rpy);
/// The same in degrees; exact at multiples of 90 degrees (SMURF scenes; MARS
/// mathUtils.cpp:133-152).
Quaternion from_rpy_degrees(const Vector3& degrees);
/// Accurate to 1e-15 rad everywhere, gimbal lock included (yaw is 0 there).
Vector3 to_rpy(const Quaternion& q);
/// Rotation by `angle` radians about a unit `axis`.
Quaternion from_axis_angle(const Vector3& axis, double angle);
/// Row-major 3x3.
std::array<double, 9> to_matrix(const Quaternion& q);

}  // namespace smurf
