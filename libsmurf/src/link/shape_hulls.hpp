// SPDX-License-Identifier: BSD-3-Clause
// The convex hulls of shapes, and how far shapes reach.
#pragma once

#include <optional>

#include "link/convex_hull.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// A hull inside that of the shape, in the frame of the shape, in m: round shapes and large meshes
/// are larger by some per cent. None if the size is unknown or not positive, or if the mesh is
/// flat.
std::optional<ConvexHull> hull_of(const LinkedModel& model, const urdf::Geometry& geometry);

/// The volume of the hull as a multiple of that of the shape. 0 if it is not known, as for an open
/// mesh.
double hull_ratio(const LinkedModel& model, const urdf::Geometry& geometry);
/// From this ratio on, gaps that matter are full in the hull.
inline constexpr double kGapsInHull = 2;

/// The farthest that a shape reaches from its origin in a direction of unit length, in its frame,
/// in m. None if its size is unknown.
std::optional<double> reach_of(const LinkedModel& model, const urdf::Geometry& geometry,
                               const Vector3& direction);

}  // namespace smurf
