// SPDX-License-Identifier: BSD-3-Clause
// A collision mesh as a body, and the closed surfaces that it consists of.
#pragma once

#include <cstdint>
#include <vector>

#include "smurf/mesh_triangles.hpp"
#include "smurf/pose.hpp"

namespace smurf {

/// A mesh in the size and the frame of its collision, which has the scale of the URDF already.
struct CollisionBody {
  std::vector<Vector3> points;         ///< m; no two are equal
  std::vector<std::uint32_t> indices;  ///< three per triangle, which turns left, seen from outside
};

CollisionBody body_of(const MeshTriangles& mesh, const Vector3& scale);

/// What a closed body encloses, in m^3; negative if it is inside out.
double volume_of(const CollisionBody& body);

/// A part of a body that no edge connects to the others.
struct BodyPiece {
  CollisionBody body;
  double volume = 0;  ///< m^3; positive
};

/// The pieces, if each is closed and none is a hollow in another; else none.
std::vector<BodyPiece> closed_pieces(const CollisionBody& body);

}  // namespace smurf
