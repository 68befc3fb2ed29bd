// SPDX-License-Identifier: BSD-3-Clause
// Masses, their centres and moments, in the frame of a body.
#pragma once

#include <array>
#include <optional>

#include "smurf/pose.hpp"

namespace smurf::imports {

/// xx, yy, zz, xy, xz, yz.
using Tensor = std::array<double, 6>;

struct MassProperties {
  double mass = 0;
  Vector3 center{};
  Tensor inertia{};  ///< about the centre, along the axes of the frame

  /// Seen from a frame in which this one has a pose.
  MassProperties in(const Pose& X) const;
  void add(const MassProperties& other);
  void scale(double factor);
};

/// 1 kg m^2 about each axis, which looks like a placeholder in a URDF, and is what a simulator has.
inline constexpr Tensor kUnitTensor{1, 1, 1, 0, 0, 0};

Tensor rotated(const Tensor& tensor, const Quaternion& rotation);

/// Moments about the principal axes, the largest first, and their frame.
struct Principal {
  Vector3 moments{};
  Quaternion axes;
};
Principal principal_of(const Tensor& tensor);
Tensor tensor_of(const Principal& principal);

/// A solid or a shell, of density 1, at its own frame.
struct Extent {
  double volume = 0;  ///< or area
  Vector3 moments{};  ///< for a mass of 1
};
Extent sphere(double radius, bool is_shell);
Extent capsule(double radius, double half_length, bool is_shell);
Extent cylinder(double radius, double half_length, bool is_shell);
Extent ellipsoid(const std::array<double, 3>& radii, bool is_shell);
Extent box(const std::array<double, 3>& half, bool is_shell);

}  // namespace smurf::imports
