// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a mesh file, for programs that show it. The library does not keep them.
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

/// A part of a mesh with one colour. Its triangles precede those of the next part.
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

/// Before any scale of the URDF. COLLADA is in metres, according to its unit, and in its own axes,
/// because RViz and Gazebo ignore its up_axis. glTF, whose y axis is up, is rotated to z, as in
/// RViz. All other files are not changed.
struct MeshTriangles {
  std::vector<std::array<float, 3>> points;  ///< points of one part differ from each other
  std::vector<std::uint32_t> indices;        ///< three per triangle, part by part in file order
  std::string reason;                ///< the reason if there are no triangles: "has no triangles"
  std::vector<MeshPart> parts = {};  ///< all of them, in the order of points and indices
  /// The texture coordinates of each point. Empty if they were not requested, or if a corner of a
  /// triangle has none.
  std::vector<TexturePoint> texture_points = {};
  bool has_textures = false;  ///< the file refers to images for its triangles, or contains images
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
