// SPDX-License-Identifier: BSD-3-Clause
// The boxes around shapes.
#pragma once

#include <optional>

#include "smurf/linked.hpp"

namespace smurf {

/// The box around a shape, in its frame, in m; none if its size is unknown or not finite.
std::optional<Box> box_of(const LinkedModel& model, const urdf::Geometry& geometry);
/// The box around a box in another frame; X_AB is the pose of its frame.
Box moved(const Box& box, const Pose& X_AB);

}  // namespace smurf
