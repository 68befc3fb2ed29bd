// SPDX-License-Identifier: BSD-3-Clause
// Convex hulls as solids, and whether two of them overlap.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/quickhull.hpp"
#include "smurf/mesh.hpp"
#include "smurf/pose.hpp"

namespace smurf {

struct ConvexHull {
  std::vector<Vector3> corners;
  std::vector<HalfSpace> sides;  ///< of its triangles
  double volume = 0;             ///< positive
};

/// None if the points lie in a plane, if there are fewer than four, or if one is not finite.
std::optional<ConvexHull> convex_hull(const std::vector<Vector3>& points);

ConvexHull moved(const ConvexHull& hull_B, const Pose& X_AB);
/// The axis-aligned box around it.
Box box_around(const ConvexHull& hull);

/// A lower bound of the length by which one hull must be moved to free the other: the diameter of a
/// ball inside both. 0 if it is less than `least`, which is positive.
double overlap_of(const ConvexHull& a, const ConvexHull& b, double least);

}  // namespace smurf
