// SPDX-License-Identifier: BSD-3-Clause
// How large a length, an angle or a mass may be.
#pragma once

#include <algorithm>
#include <cmath>

#include "smurf/pose.hpp"

namespace smurf {

/// m, rad or kg. The poses, masses and inertias that any number of such quantities make
/// together are finite; nothing that is built comes near it.
inline constexpr double kLargestQuantity = 1e60;

inline bool is_quantity(double value) { return std::fabs(value) <= kLargestQuantity; }

/// The same of what quantities were composed to.
inline bool is_usable(const Pose& pose) {
  constexpr double kLargestSum = 1e10 * kLargestQuantity;
  const Quaternion& q = pose.orientation;
  return std::all_of(pose.position.begin(), pose.position.end(),
                     [](double value) { return std::fabs(value) <= kLargestSum; }) &&
         std::isfinite(q.w + q.x + q.y + q.z);
}

}  // namespace smurf
