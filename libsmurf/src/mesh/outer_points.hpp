// SPDX-License-Identifier: BSD-3-Clause
// The points of a mesh from which its convex hull is made.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "smurf/pose.hpp"

namespace smurf {

/// Keeps all corners of a small mesh. Of a larger one, it keeps those that are outermost in 14
/// directions, and a sample of the others: the hull of these points lies inside that of the mesh.
class OuterPoints {
 public:
  using Point = std::array<float, 3>;
  /// Each corner of a small mesh is kept.
  static constexpr std::size_t kMostKept = 256;

  void add(const Vector3& a, const Vector3& b, const Vector3& c);
  std::vector<Point> take();

 private:
  void keep(const Point& corner);
  void thin_out();
  void extend(const Point& point);

  /// The axes of a cube through its faces and its corners, and 0, which makes eight.
  static constexpr std::size_t kAxes = 8;
  std::vector<Point> kept_;
  std::uint64_t corners_ = 0;  ///< so far
  std::uint64_t next_ = 0;     ///< the number of the corner that is kept next
  std::uint64_t stride_ = 1;   ///< from there to the one after it; a power of two
  std::array<float, kAxes> least_{}, most_{};
  std::array<Point, 2 * kAxes> outermost_{};
};

}  // namespace smurf
