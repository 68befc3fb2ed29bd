// SPDX-License-Identifier: BSD-3-Clause
// Bytes -> MeshFacts: small readers of the formats that robots use.
#pragma once

#include <functional>
#include <string_view>

#include "smurf/mesh.hpp"
#include "smurf/mesh_triangles.hpp"

namespace smurf {

/// Receives the corners of every triangle whose points precede it in the file.
using TriangleVisitor = std::function<void(const Vector3& a, const Vector3& b, const Vector3& c)>;

/// Reads a whole mesh file. Defects are in the result and not reported, because findings
/// belong at the place that uses the mesh. `extension` (".stl", any case) is used only if
/// the bytes are ambiguous. `visit` may be empty; it receives the triangles in the unit of
/// the file. `neighbours` reads the buffers that a glTF names.
MeshFacts read_mesh(std::string_view bytes, std::string_view extension,
                    const TriangleVisitor& visit = {}, const MeshNeighbours& neighbours = {});

/// `extension` as above.
MeshFormat format_of_mesh(std::string_view bytes, std::string_view extension);

/// The texture files that a material library (.mtl) names.
std::vector<MeshDependency> read_material_library(std::string_view text);
/// Whether an OBJ has faces that do not belong to its first group. MuJoCo does not read them
/// (tinyobjloader makes a shape of each `o` or `g`; user_mesh.cc uses the first).
bool has_faces_after_first_group(std::string_view text);

}  // namespace smurf
