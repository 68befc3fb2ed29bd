// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a mesh file, for programs that show it. Only the caller keeps them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/file_reader.hpp"
#include "smurf/flat_shape.hpp"
#include "smurf/limits.hpp"

namespace smurf {

/// The triangles of one colour, up to those of the next part.
struct MeshPart {
  std::uint32_t first_point = 0;
  std::uint32_t first_index = 0;
  std::optional<Rgba> color;  ///< that the file gives them
};

/// Before any scale of the URDF. COLLADA is in metres, as its unit says, and in its own axes, since
/// RViz and Gazebo ignore its up_axis. glTF, whose y axis is up, is turned to z, as RViz turns
/// it. All other files are as they are.
struct MeshTriangles {
  std::vector<std::array<float, 3>> points;  ///< no two of a part are equal
  std::vector<std::uint32_t> indices;        ///< three a triangle, in the order of the file by part
  std::string reason;                        ///< why there are none: "has no triangles"
  std::vector<MeshPart> parts = {};          ///< all of them, in the order of points and indices
};

/// Reads a file that a mesh names, relative to the mesh.
using MeshNeighbours = std::function<FileContent(const std::string& name)>;

/// STL, OBJ, bobj, COLLADA and glTF. `extension` as for the facts of a mesh. A glTF may have its
/// points in other files, which are not read without `neighbours`.
MeshTriangles read_triangles(std::string_view bytes, std::string_view extension,
                             const MeshNeighbours& neighbours = {});
/// The same for a file.
MeshTriangles read_triangles_of(const std::string& path, const FileReader& files,
                                const Limits& limits);

}  // namespace smurf
