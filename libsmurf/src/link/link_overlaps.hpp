// SPDX-License-Identifier: BSD-3-Clause
// The collisions of a robot that are inside each other, as convex hulls.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "link/shape_hulls.hpp"
#include "smurf/linked.hpp"

namespace smurf {

/// By link: the topmost link to which fixed joints connect it. Such links are one body.
std::vector<std::size_t> bodies_of(const LinkedModel& model);

/// Whether two links are neither one body nor neighbours. `bodies`: those of bodies_of().
bool are_apart(const LinkedModel& model, const std::vector<std::size_t>& bodies, std::size_t link,
               std::size_t other);

/// Zero, or the bound that is nearest to it, of all joints with bounds.
JointPositions rest_positions(const LinkedModel& model);

/// Two links that are neither one body nor neighbours.
struct LinkOverlap {
  std::size_t link = 0, other = 0;  ///< the first is the smaller one
  const urdf::Collision* collision = nullptr;
  const urdf::Collision* other_collision = nullptr;
  double depth = 0;      ///< m, as overlap_of()
  double thickness = 0;  ///< m, of the thinner shape
};

/// Keeps the hulls of a robot between positions of its joints.
class LinkOverlaps {
 public:
  /// The model must outlive this object.
  explicit LinkOverlaps(const LinkedModel& model);
  /// The deepest overlap of each pair of links. None for robots with very many shapes, or with very
  /// many pairs that are near each other. `least`: the depth that counts, m; a `part` of the
  /// thinner shape, if that is less.
  std::vector<LinkOverlap> find(const JointPositions& positions, double least, double part = 0);

 private:
  struct Shape {
    const urdf::Collision* collision;
    std::size_t link;
    Pose X_LC;
    Box own;  ///< in the frame of the collision
    std::optional<ConvexHull> hull = std::nullopt;
    bool has_tried = false;  ///< to make the hull
  };
  struct Placed;

  const ConvexHull* hull_of(Shape& shape) const;

  const LinkedModel& model_;
  std::vector<std::size_t> bodies_;
  std::vector<Shape> shapes_;
};

}  // namespace smurf
