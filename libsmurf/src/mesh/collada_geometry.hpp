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
    std::vector<std::uint32_t> corners;  ///< three per triangle, in `points`
  };
  std::vector<Vector3> points;
  /// The texture coordinates of each point. Empty if they were not requested, or if no primitive
  /// has any.
  std::vector<TexturePoint> texture_points;
  std::vector<Part> parts;
};

/// A problem at an element.
struct Problem {
  xml::View element;
  std::string what;
  bool is_defect = true;  ///< false: the file is sound, but this reader does not support it
};

/// Reads geometries one after the other; stops at the first problem.
class GeometryReader {
 public:
  /// `known` has numbers that were read before; they are moved out of it. It may be null.
  explicit GeometryReader(TexturePoints texture_points, NumberLists* known)
      : wants_textures_(texture_points == TexturePoints::read), known_(known) {}

  /// Empty for curves and other things without triangles.
  Geometry read(xml::View geometry);
  const std::optional<Problem>& problem() const { return problem_; }

 private:
  /// The meaning of the indices in the lists of a primitive.
  struct Indices {
    std::size_t stride = 1;  ///< distance from one corner to the next
    std::size_t offset = 0;  ///< offset of the index of the point
    /// The place of the index of the texture coordinates among the indices of a corner.
    std::size_t texture_offset = 0;
    const std::vector<TexturePoint>* textures = nullptr;  ///< null: the corners have none
  };
  bool read_points(xml::View mesh, Geometry& geometry);
  std::vector<double> numbers_of(xml::View array);
  void read_primitives(xml::View element, Geometry& geometry);
  std::optional<Indices> indices_of(xml::View primitives);
  bool read_corners(xml::View list, const Indices& indices, Geometry& geometry);
  bool add(xml::View primitives, Geometry& geometry, std::vector<std::uint32_t>& corners);
  bool add_polygons(xml::View primitives, Geometry& geometry, std::vector<std::uint32_t>& corners);
  bool fail(xml::View element, std::string what, bool is_defect = true);

  bool wants_textures_;
  NumberLists* known_;
  std::size_t points_ = 0;  ///< the geometry as written
  std::optional<TextureSources> sources_;
  TexturedPoints textured_;
  std::vector<std::uint32_t> corners_;  ///< the last list that was read
  std::vector<std::int64_t> textures_;  ///< of its corners
  PolygonSplitter splitter_;
  std::optional<Problem> problem_;
};

}  // namespace smurf::collada
