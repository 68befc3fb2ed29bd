// SPDX-License-Identifier: BSD-3-Clause
// Axes at right angles, for shapes that are fitted to points.
#pragma once

#include <array>
#include <cmath>

#include "base/numbers/vectors.hpp"
#include "smurf/pose.hpp"

namespace smurf {

/// Three unit vectors at right angles that turn left: the columns of a rotation.
using Axes = std::array<Vector3, 3>;

inline Vector3 unit(const Vector3& vector) {
  const double length = std::sqrt(dot(vector, vector));
  return {vector[0] / length, vector[1] / length, vector[2] / length};
}

/// Axes whose third one is the given unit vector.
Axes axes_along(const Vector3& direction);

/// The point with these coordinates along the axes.
inline Vector3 along(const Axes& axes, const Vector3& coordinates) {
  Vector3 point{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) point[k] += coordinates[i] * axes[i][k];
  }
  return point;
}

}  // namespace smurf
