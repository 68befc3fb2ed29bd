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
  std::optional<Rgba> color;  ///< if the file gives one
};

/// Texture coordinates: (0, 0) is the lower left corner of an image and (1, 1) its upper right one.
using TexturePoint = std::array<float, 2>;
/// Whether a reader also reads texture coordinates. If it does, a point with two texture
/// coordinates becomes two points.
enum class TexturePoints : std::uint8_t { ignored, read };

/// Before any scale of the URDF. COLLADA is in metres, as its unit says, and in its own axes, since
/// RViz and Gazebo ignore its up_axis. glTF, whose y axis is up, is turned to z, as RViz turns
/// it. All other files are as they are.
struct MeshTriangles {
  std::vector<std::array<float, 3>> points;  ///< no two of a part are equal
  std::vector<std::uint32_t> indices;        ///< three a triangle, in the order of the file by part
  std::string reason;                        ///< why there are none: "has no triangles"
  std::vector<MeshPart> parts = {};          ///< all of them, in the order of points and indices
  /// The texture coordinates of each point. Empty when they were not asked for, or when a corner of
  /// a triangle has none.
  std::vector<TexturePoint> texture_points = {};
  bool has_textures = false;  ///< the file names images for its triangles, or contains them
};

/// Reads a file that a mesh names, relative to the mesh.
using MeshNeighbours = std::function<FileContent(const std::string& name)>;

/// STL, OBJ, bobj, COLLADA and glTF. `extension` as for the facts of a mesh. A glTF may have its
/// points in other files, which are not read without `neighbours`.
MeshTriangles read_triangles(std::string_view bytes, std::string_view extension,
                             const MeshNeighbours& neighbours = {},
                             TexturePoints texture_points = TexturePoints::ignored);
/// Reads the triangles of a mesh file.
MeshTriangles read_triangles_of(const std::string& path, const FileReader& files,
                                const Limits& limits,
                                TexturePoints texture_points = TexturePoints::ignored);

}  // namespace smurf
