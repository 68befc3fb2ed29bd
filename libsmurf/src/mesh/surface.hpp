// SPDX-License-Identifier: BSD-3-Clause
// Sums over the points and triangles of a surface.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "mesh/affine.hpp"
#include "mesh/mesh_reader.hpp"
#include "mesh/outer_points.hpp"
#include "smurf/mesh.hpp"

namespace smurf {

class BoxSum {
 public:
  void add(const Vector3& point) {
    if (!box_) {
      box_ = Box{point, point};
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) {
      box_->low[i] = std::min(box_->low[i], point[i]);
      box_->high[i] = std::max(box_->high[i], point[i]);
    }
  }
  void add(const Box& box);
  /// The corners of a box, transformed.
  void add_corners(const Box& box, const Affine& X);
  const std::optional<Box>& box() const { return box_; }
  /// The box around all points. None if there are none, or if a transform made a point infinite.
  std::optional<Box> finite_box() const;

 private:
  std::optional<Box> box_;
};

/// The volume and its moments by signed tetrahedra from the first point, so a mesh far from the
/// origin keeps its precision.
class SurfaceSum {
 public:
  /// Passes every triangle to `visit`, if it is set; it must outlive this object.
  explicit SurfaceSum(const TriangleVisitor& visit) : visit_(visit) {}

  void add(const Vector3& a, const Vector3& b, const Vector3& c);
  /// Writes the solid, the closure and the outer points of the surface. A surface that is closed,
  /// but has each triangle twice, gets no solid.
  void write_to(MeshFacts& facts);

 private:
  /// A number for the edge.
  std::uint64_t add_edge(std::uint64_t from, std::uint64_t to);
  bool is_doubled() const { return origin_ && area_ > 0 && triangle_parity_ == 0; }
  Closure closure() const;
  /// None if the sum of area vectors shows a hole in the surface.
  std::optional<Solid> solid() const;

  const TriangleVisitor& visit_;
  std::optional<Vector3> origin_;
  OuterPoints outer_;
  double volume_ = 0;               ///< six times the volume
  Vector3 first_{};                 ///< 24 times the first moments about the first point
  std::array<double, 6> second_{};  ///< 120 times the second moments
  double area_ = 0;                 ///< twice the area
  Vector3 area_vector_{};           ///< sum of twice the area vectors
  // Sums of random numbers, one for each edge: 0 if each edge occurs once in each direction, or an
  // even number of times.
  std::uint64_t directed_ = 0, parity_ = 0;
  std::uint64_t triangle_parity_ = 0;  ///< the same for triangles: 0 if each occurs twice
};

}  // namespace smurf
