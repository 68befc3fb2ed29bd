// SPDX-License-Identifier: BSD-3-Clause
// The smallest boxes and capsules around a convex hull.
#pragma once

#include "mesh/convex_mesh.hpp"
#include "smurf/pose.hpp"

namespace smurf {

/// A box in the frame M of the points: its centre and axes, and the lengths of its edges.
struct FittedBox {
  Pose X_MB;
  Vector3 size{};

  double volume() const { return size[0] * size[1] * size[2]; }
};

/// The smallest box among those that have a face in the plane of a face of the hull, and the one
/// along the coordinate axes. It contains all corners of the hull.
FittedBox fitted_box(const ConvexMesh& hull);

/// A capsule along z of its frame, in the frame M of the points; a ball if its length is 0.
struct FittedCapsule {
  Pose X_MC;
  double radius = 0;
  double length = 0;  ///< of the cylindrical part

  double volume() const;
};

/// A small capsule or ball around the hull: the best of some directions, which are then turned
/// until no small turn makes it smaller. It contains all corners of the hull.
FittedCapsule fitted_capsule(const ConvexMesh& hull);

}  // namespace smurf
