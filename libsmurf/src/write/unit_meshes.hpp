// SPDX-License-Identifier: BSD-3-Clause
// Triangles of the shapes that are no meshes, for formats without such shapes; scaled to size by
// their users.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "smurf/flat_shape.hpp"
#include "smurf/pose.hpp"

namespace smurf {

struct TriangleMesh {
  std::vector<std::array<float, 3>> points, normals;  ///< one normal a point, outwards
  std::vector<std::uint16_t> indices;                 ///< three a triangle, counterclockwise
};

/// Around the origin of their frame.
enum class Solid : std::uint8_t {
  box,       ///< edges of length 1
  sphere,    ///< radius 1
  cylinder,  ///< radius 1, from z = -0.5 to 0.5
  square     ///< from -0.5 to 0.5 in x and y, at z = 0, seen from above
};
TriangleMesh unit_mesh(Solid solid);

struct PlacedSolid {
  Solid solid{};
  Pose X_GS;  ///< in the frame of the shape
  Vector3 scale{};
};
/// The solids that a shape is made of: several for a capsule, none for a mesh or a heightmap.
std::vector<PlacedSolid> solids_of(const FlatGeometry& geometry);

}  // namespace smurf
