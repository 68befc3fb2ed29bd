// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a <geometry> of COLLADA in its own frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "mesh/collada_file.hpp"
#include "mesh/polygons.hpp"

namespace smurf::collada {

struct Geometry {
  /// Triangles with one material.
  struct Part {
    std::string_view material;           ///< a symbol that the instances bind
    std::vector<std::uint32_t> corners;  ///< three a triangle, in `points`
  };
  std::vector<Vector3> points;
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
  /// Empty for curves and other things without triangles.
  Geometry read(xml::View geometry);
  const std::optional<Problem>& problem() const { return problem_; }

 private:
  /// What the indices in the lists of a primitive mean.
  struct Indices {
    std::size_t stride = 1;  ///< from a corner to the next
    std::size_t offset = 0;  ///< of the index of the point
  };
  bool read_points(xml::View mesh, Geometry& geometry);
  void read_primitives(xml::View element, Geometry& geometry);
  std::optional<Indices> indices_of(xml::View primitives);
  bool read_corners(xml::View list, const Indices& indices, std::size_t points);
  bool add(xml::View primitives, const Geometry& geometry, std::vector<std::uint32_t>& corners);
  bool add_polygons(xml::View primitives, const Geometry& geometry,
                    std::vector<std::uint32_t>& corners);
  bool fail(xml::View element, std::string what, bool is_defect = true);

  std::vector<std::uint32_t> corners_;  ///< of the list read last
  PolygonSplitter splitter_;
  std::optional<Problem> problem_;
};

}  // namespace smurf::collada
