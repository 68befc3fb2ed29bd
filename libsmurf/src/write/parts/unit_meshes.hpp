// SPDX-License-Identifier: BSD-3-Clause
// Triangles of boxes, spheres and other primitive shapes, for formats without them. The caller
// scales them to size.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "smurf/flat_shape.hpp"
#include "smurf/pose.hpp"

namespace smurf {

struct TriangleMesh {
  std::vector<std::array<float, 3>> points, normals;  ///< one normal per point, outward
  std::vector<std::uint16_t> indices;                 ///< three per triangle, counterclockwise
};

/// Around the origin of their frame.
enum class UnitShape : std::uint8_t {
  box,       ///< edges of length 1
  sphere,    ///< radius 1
  cylinder,  ///< radius 1, from z = -0.5 to 0.5
  square     ///< from -0.5 to 0.5 in x and y, at z = 0, seen from above
};
TriangleMesh unit_mesh(UnitShape solid);

struct PlacedSolid {
  UnitShape solid{};
  Pose X_GS;  ///< in the frame of the shape
  Vector3 scale{};
};
/// The solids of a shape: several for a capsule, none for a mesh or a heightmap.
std::vector<PlacedSolid> solids_of(const FlatGeometry& geometry);

}  // namespace smurf
