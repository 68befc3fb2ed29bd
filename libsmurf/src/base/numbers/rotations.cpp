// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/rotations.hpp"

#include <cmath>

namespace smurf {

Quaternion from_axes(const Vector3& x, const Vector3& y, const Vector3& z) {
  // Of the four ways to solve for a quaternion, the one that divides by the largest number.
  const double trace = x[0] + y[1] + z[2];
  Quaternion q;
  if (trace > 0) {
    q.w = 0.5 * std::sqrt(1 + trace);
    q.x = 0.25 * (y[2] - z[1]) / q.w;
    q.y = 0.25 * (z[0] - x[2]) / q.w;
    q.z = 0.25 * (x[1] - y[0]) / q.w;
  } else if (x[0] > y[1] && x[0] > z[2]) {
    q.x = 0.5 * std::sqrt(1 + x[0] - y[1] - z[2]);
    q.w = 0.25 * (y[2] - z[1]) / q.x;
    q.y = 0.25 * (y[0] + x[1]) / q.x;
    q.z = 0.25 * (z[0] + x[2]) / q.x;
  } else if (y[1] > z[2]) {
    q.y = 0.5 * std::sqrt(1 - x[0] + y[1] - z[2]);
    q.w = 0.25 * (z[0] - x[2]) / q.y;
    q.x = 0.25 * (y[0] + x[1]) / q.y;
    q.z = 0.25 * (z[1] + y[2]) / q.y;
  } else {
    q.z = 0.5 * std::sqrt(1 - x[0] - y[1] + z[2]);
    q.w = 0.25 * (x[1] - y[0]) / q.z;
    q.x = 0.25 * (z[0] + x[2]) / q.z;
    q.y = 0.25 * (z[1] + y[2]) / q.z;
  }
  return normalized(q);
}

}  // namespace smurf
