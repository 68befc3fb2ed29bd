// SPDX-License-Identifier: BSD-3-Clause
// Collects the triangles of a mesh file by their colour.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "smurf/mesh_triangles.hpp"
#include "smurf/pose.hpp"

namespace smurf {

class TriangleCollector {
 public:
  explicit TriangleCollector(std::size_t most_triangles);

  /// The colour of the triangles that follow.
  void set_color(const std::optional<Rgba>& color);
  /// False when there are too many triangles, or when a coordinate is beyond all measure: there is
  /// a reason then, and the reader of the file may stop.
  bool add(const Vector3& a, const Vector3& b, const Vector3& c);
  /// "has more than 3000000 triangles"; empty while all is well.
  const std::string& reason() const { return reason_; }
  std::size_t triangles() const { return triangles_; }

  /// All triangles, or none and the reason.
  MeshTriangles take();

 private:
  using Point = std::array<float, 3>;
  struct HashOfPoint {
    std::size_t operator()(const Point& point) const;
  };
  /// Triangles of one colour. Equal points become one.
  struct Part {
    std::optional<Rgba> color;
    std::vector<Point> points;
    std::vector<std::uint32_t> indices;
    std::unordered_map<Point, std::uint32_t, HashOfPoint> known;
  };
  bool add(Part& part, const Vector3& point);

  std::size_t most_triangles_;
  std::vector<Part> parts_;
  std::map<std::optional<Rgba>, std::size_t> part_of_color_;
  std::size_t current_ = 0;
  std::size_t triangles_ = 0;
  std::string reason_;
};

}  // namespace smurf
