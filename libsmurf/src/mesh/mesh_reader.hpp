// SPDX-License-Identifier: BSD-3-Clause
// Bytes -> MeshFacts: small readers of the formats that robots use.
#pragma once

#include <functional>
#include <string_view>

#include "smurf/mesh.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {

/// Takes the corners of every triangle whose points are known when it is named.
using TriangleVisitor = std::function<void(const Vector3& a, const Vector3& b, const Vector3& c)>;

/// Reads a whole mesh file. What is broken is a defect of the result; nothing is reported here,
/// as the place a person looks at is where the mesh is used. `extension` (".stl", any case) helps
/// only when the bytes alone could be several things. `visit` may be empty; COLLADA and glTF, whose
/// triangles only read_triangles() places, have nothing for it. `neighbours` reads the buffers
/// that a glTF names.
MeshFacts read_mesh(std::string_view bytes, std::string_view extension,
                    const TriangleVisitor& visit = {}, const MeshNeighbours& neighbours = {});

/// `extension` as above.
MeshFormat format_of_mesh(std::string_view bytes, std::string_view extension);

/// The texture files that a material library (.mtl) names.
std::vector<MeshDependency> read_material_library(std::string_view text);

}  // namespace smurf
