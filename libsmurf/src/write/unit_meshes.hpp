// SPDX-License-Identifier: BSD-3-Clause
// Triangles of the solids that other formats have and glTF has not; scaled to size by their users.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace smurf {

struct TriangleMesh {
  std::vector<std::array<float, 3>> points, normals;  ///< one normal a point, outwards
  std::vector<std::uint16_t> indices;                 ///< three a triangle, counterclockwise
};

/// Edges of length 1, around the origin.
TriangleMesh unit_box();
/// Radius 1.
TriangleMesh unit_sphere();
/// Radius 1, from z = -0.5 to 0.5.
TriangleMesh unit_cylinder();
/// From -0.5 to 0.5 in x and y, at z = 0, seen from above.
TriangleMesh unit_square();

}  // namespace smurf
