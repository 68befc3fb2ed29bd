// SPDX-License-Identifier: BSD-3-Clause
// Whether two convex hulls touch, fast: for many poses of the same hulls.
#pragma once

#include <array>
#include <vector>

#include "smurf/pose.hpp"

namespace smurf {

/// The corners of a hull, in its own frame, and the ball around them.
struct HullCorners {
  std::vector<Vector3> corners;  ///< m; not empty
  Vector3 center{};              ///< m
  double radius = 0;             ///< m, of the ball about the centre
};

HullCorners hull_corners(std::vector<Vector3> corners);

/// A hull in the frame of two that are compared. It must not outlive the corners.
class PlacedHull {
 public:
  PlacedHull(const HullCorners& hull, const Pose& X_WH);

  /// In W.
  const Vector3& center() const { return center_; }
  double radius() const { return hull_->radius; }
  /// The corner that is farthest in a direction, in W; the hull is `size` times as large.
  Vector3 farthest(const Vector3& direction, double size) const;

 private:
  const HullCorners* hull_;
  std::array<double, 9> rotation_;
  Vector3 position_;
  Vector3 center_;
};

/// The algorithm of Gilbert, Johnson and Keerthi. `axis` is a direction in which the hulls were
/// apart before, or any other; afterwards, one in which they are apart, if they are. Hulls that are
/// almost in contact may count as touching.
bool are_touching(const PlacedHull& a, const PlacedHull& b, double size, Vector3& axis);

}  // namespace smurf
