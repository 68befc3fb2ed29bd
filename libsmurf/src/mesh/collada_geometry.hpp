// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a <geometry> of COLLADA in its own frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "mesh/collada_texture.hpp"
#include "mesh/polygons.hpp"

namespace smurf::collada {

struct Geometry {
  /// Triangles with one material.
  struct Part {
    std::string_view material;           ///< a symbol that the instances bind
    std::vector<std::uint32_t> corners;  ///< three a triangle, in `points`
  };
  std::vector<Vector3> points;
  /// The texture coordinates of each point. Empty when they were not asked for, or when no
  /// primitive has any.
  std::vector<TexturePoint> texture_points;
  std::vector<Part> parts;
};

/// What is wrong at an element.
struct Problem {
  xml::View element;
  std::string what;
  bool is_defect = true;  ///< otherwise the file is sound, and only not read here
};

/// Reads one after the other; the first problem ends it.
class GeometryReader {
 public:
  explicit GeometryReader(TexturePoints texture_points)
      : wants_textures_(texture_points == TexturePoints::read) {}

  /// Empty for curves and other things without triangles.
  Geometry read(xml::View geometry);
  const std::optional<Problem>& problem() const { return problem_; }

 private:
  /// What the indices in the lists of a primitive mean.
  struct Indices {
    std::size_t stride = 1;  ///< from a corner to the next
    std::size_t offset = 0;  ///< of the index of the point
    /// The place of the index of the texture coordinates among the indices of a corner.
    std::size_t texture_offset = 0;
    const std::vector<TexturePoint>* textures = nullptr;  ///< null when the corners have none
  };
  bool read_points(xml::View mesh, Geometry& geometry);
  void read_primitives(xml::View element, Geometry& geometry);
  std::optional<Indices> indices_of(xml::View primitives);
  bool read_corners(xml::View list, const Indices& indices, Geometry& geometry);
  bool add(xml::View primitives, Geometry& geometry, std::vector<std::uint32_t>& corners);
  bool add_polygons(xml::View primitives, Geometry& geometry, std::vector<std::uint32_t>& corners);
  bool fail(xml::View element, std::string what, bool is_defect = true);

  bool wants_textures_;
  std::size_t points_ = 0;  ///< of the geometry as written
  std::optional<TextureSources> sources_;
  TexturedPoints textured_;
  std::vector<std::uint32_t> corners_;  ///< of the list read last
  std::vector<std::int64_t> textures_;  ///< of its corners
  PolygonSplitter splitter_;
  std::optional<Problem> problem_;
};

}  // namespace smurf::collada
