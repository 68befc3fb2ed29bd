// SPDX-License-Identifier: BSD-3-Clause
// Collects the triangles of a mesh file by their colour.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "smurf/mesh_triangles.hpp"
#include "smurf/pose.hpp"

namespace smurf {

/// The texture coordinates of a corner that has none.
inline constexpr TexturePoint kNoTexturePoint{std::numeric_limits<float>::quiet_NaN(),
                                              std::numeric_limits<float>::quiet_NaN()};
/// The texture coordinates of the three corners of a triangle.
using TextureCorners = std::array<TexturePoint, 3>;
/// Texture coordinates from two numbers; kNoTexturePoint if a number is implausibly
/// large.
TexturePoint texture_point(double u, double v);

class TriangleCollector {
 public:
  TriangleCollector(std::size_t most_triangles, TexturePoints texture_points);
  /// Passes the triangles on, without colours and texture coordinates, instead of keeping them.
  using Visitor = std::function<void(const Vector3& a, const Vector3& b, const Vector3& c)>;
  TriangleCollector(std::size_t most_triangles, Visitor visit);

  /// Sets the colour of the following triangles.
  void set_color(const std::optional<Rgba>& color);
  /// Adds a triangle. If there are too many triangles, or if a coordinate is too large, sets a
  /// reason and returns false; the reader of the file may then stop. Ignores texture coordinates if
  /// they were not requested.
  bool add(const Vector3& a, const Vector3& b, const Vector3& c,
           const TextureCorners& textures = {kNoTexturePoint, kNoTexturePoint, kNoTexturePoint});
  bool wants_texture_points() const { return texture_points_ == TexturePoints::read; }
  /// The file has textures.
  void note_textures() { has_textures_ = true; }
  /// "has more than 3000000 triangles"; empty if there is no problem.
  const std::string& reason() const { return reason_; }
  std::size_t triangles() const { return triangles_; }

  /// All triangles; or no triangles, and the reason.
  MeshTriangles take();

 private:
  using Point = std::array<float, 3>;
  using TexturedPoint = std::array<float, 5>;
  template <std::size_t Size>
  struct HashOf {
    std::size_t operator()(const std::array<float, Size>& point) const;
  };
  template <std::size_t Size>
  using Known = std::unordered_map<std::array<float, Size>, std::uint32_t, HashOf<Size>>;
  /// Triangles of one colour. Equal points become one.
  struct Part {
    std::optional<Rgba> color;
    std::vector<Point> points;
    std::vector<std::uint32_t> indices;
    Known<3> known;
    std::vector<TexturePoint> texture_points;  ///< for each point, if requested
    Known<5> known_textured;
  };
  static std::optional<Point> to_single(const Vector3& point);
  static bool add(Part& part, const Vector3& point);
  bool add(Part& part, const Vector3& point, const TexturePoint& texture);

  std::size_t most_triangles_;
  Visitor visit_;
  TexturePoints texture_points_;
  bool has_textures_ = false, lacks_texture_points_ = false;
  std::vector<Part> parts_;
  std::map<std::optional<Rgba>, std::size_t> part_of_color_;
  std::size_t current_ = 0;
  std::size_t triangles_ = 0;
  std::string reason_;
};

}  // namespace smurf
