// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a mesh file, for programs that show it. Only the caller keeps them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// In the file's own unit and axes, before any scale of the URDF.
struct MeshTriangles {
  std::vector<std::array<float, 3>> points;  ///< no two are equal
  std::vector<std::uint32_t> indices;        ///< three a triangle, in the order of the file
  std::string reason;  ///< why there are none: "is COLLADA, of which no triangles are read"
};

/// STL, OBJ and bobj. `extension` as for the facts of a mesh.
MeshTriangles read_triangles(std::string_view bytes, std::string_view extension);
/// The same for a file.
MeshTriangles read_triangles_of(const std::string& path, const FileReader& files,
                                const Limits& limits);

}  // namespace smurf
