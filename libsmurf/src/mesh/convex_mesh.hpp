// SPDX-License-Identifier: BSD-3-Clause
// The convex hull of any number of points as a mesh, and the volume that several hulls fill.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/quickhull.hpp"
#include "smurf/mesh.hpp"
#include "smurf/pose.hpp"

namespace smurf {

/// All lengths are in the unit of the points.
struct ConvexMesh {
  std::vector<Vector3> points;  ///< its corners
  /// Corners, as indices of `points`, which turn left, seen from outside.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<HalfSpace> sides;  ///< of the triangles
  double volume = 0;             ///< positive
};

/// The smallest box with faces along the axes around some points; at least one.
Box box_of(std::span<const Vector3> points);

/// The hull. It contains all points, except for 4e-7 of their extent: the precision of the
/// coordinates of mesh files. None if they lie in a plane, if there are fewer than four, or if one
/// is not finite.
std::optional<ConvexMesh> convex_mesh(std::span<const Vector3> points);

/// The volume of all hulls together, where what several of them fill counts once. The overlaps are
/// sampled with 4096 points in each hull, the same in every run.
double volume_of_union(std::span<const ConvexMesh> hulls);

}  // namespace smurf
