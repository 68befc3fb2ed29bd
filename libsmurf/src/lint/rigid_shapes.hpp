// SPDX-License-Identifier: BSD-3-Clause
// The shapes of links that fixed joints make one body, placed in the frame of the root.
#pragma once

#include <optional>
#include <vector>

#include "lint/geometry_queries.hpp"

namespace smurf {

/// What a body reaches.
struct RigidShape {
  std::vector<Vector3> points;  ///< corners of the boxes of shapes, in the frame of the root, m
  std::optional<Box> box;       ///< around them
  bool is_known = true;         ///< the sizes of all shapes are known
  bool has_collision = false;
};
/// By link; those of a body are at its topmost link. Joints are at zero. Empty if there are too
/// many shapes.
std::vector<RigidShape> rigid_shapes(const LinkedModel& model,
                                     const std::vector<std::optional<Pose>>& poses,
                                     const std::vector<std::size_t>& body);

double diagonal_of(const Box& box);
/// Distance between the nearest points of a box and a point, 0 inside.
double distance_to(const Box& box, const Vector3& point);
/// Distance from a line through a point, whose direction has unit length, to the convex hull of
/// points, 0 if it passes through it.
double distance_from_line(const Vector3& point, const Vector3& direction,
                          const std::vector<Vector3>& points);

}  // namespace smurf
