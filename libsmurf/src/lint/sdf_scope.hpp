// SPDX-License-Identifier: BSD-3-Clause
// What the `gazebo` elements of a URDF add to the model that sdformat makes of it.
#pragma once

#include "lint/sdf_checks.hpp"
#include "smurf/linked.hpp"

namespace smurf::sdf {

/// The pose of a sensor or projector in a link that sdformat joins with another.
inline constexpr Circumstance kMovedPose{"pose that Gazebo writes again"};

/// Reports what sdformat refuses in the extensions, but not the values that it translates.
void check_extensions(const LinkedModel& model, const Report& report);

}  // namespace smurf::sdf
