// SPDX-License-Identifier: BSD-3-Clause
// The faces of convex hulls.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "smurf/pose.hpp"

namespace smurf {

/// A half-space: the points p with dot(normal, p) <= distance. The normal has unit length.
struct HalfSpace {
  Vector3 normal{};
  double distance = 0;
};

/// A triangle of a hull. Its corners, indices of points, turn left, seen from outside.
struct HullFace {
  std::array<std::uint32_t, 3> corners{};
  HalfSpace side;
};

/// The hull of some hundred points. Points that are less than `tolerance` (m, positive) above a
/// face are in it. None if they lie in a plane, if there are fewer than four, if one is not finite,
/// or if rounding errors exceed the tolerance.
std::optional<std::vector<HullFace>> quickhull(const std::vector<Vector3>& points,
                                               double tolerance);

}  // namespace smurf
