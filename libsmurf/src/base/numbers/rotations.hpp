// SPDX-License-Identifier: BSD-3-Clause
// A rotation from its axes.
#pragma once

#include "smurf/pose.hpp"

namespace smurf {

/// The rotation that turns the coordinate axes into these three: unit vectors at right angles, of
/// which the third is the cross product of the others.
Quaternion from_axes(const Vector3& x, const Vector3& y, const Vector3& z);

}  // namespace smurf
