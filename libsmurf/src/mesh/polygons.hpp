// SPDX-License-Identifier: BSD-3-Clause
// Polygons as triangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "smurf/pose.hpp"

namespace smurf {

class PolygonSplitter {
 public:
  /// Appends three corners for each triangle. Corners are places in `points`. A polygon that is not
  /// convex is cut along its inside, unless it has too many corners.
  void split(std::span<const std::uint32_t> corners, const std::vector<Vector3>& points,
             std::vector<std::uint32_t>& triangles);

 private:
  struct Corner {
    std::uint32_t index;
    double x, y;
  };
  bool is_ear(std::size_t place);
  void cut(std::vector<std::uint32_t>& triangles);

  std::vector<Corner> left_;
  /// Limits the work for all polygons together: cutting one takes time cubic in its corners.
  std::uint64_t steps_left_ = 50'000'000;
};

}  // namespace smurf
