// SPDX-License-Identifier: BSD-3-Clause
// The largest allowed length, angle and mass.
#pragma once

#include <algorithm>
#include <cmath>

#include "smurf/pose.hpp"

namespace smurf {

/// m, rad or kg. Any number of such quantities gives finite poses, masses and inertias; real robots
/// are far below this.
inline constexpr double kLargestQuantity = 1e60;

inline bool is_quantity(double value) { return std::fabs(value) <= kLargestQuantity; }

/// The same limit for composed quantities.
inline bool is_usable(const Pose& pose) {
  constexpr double kLargestSum = 1e10 * kLargestQuantity;
  const Quaternion& q = pose.orientation;
  return std::all_of(pose.position.begin(), pose.position.end(),
                     [](double value) { return std::fabs(value) <= kLargestSum; }) &&
         std::isfinite(q.w + q.x + q.y + q.z);
}

}  // namespace smurf
