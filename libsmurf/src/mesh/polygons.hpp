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
  /// Appends three corners per triangle. Corners are indices into `points`. A polygon that is not
  /// convex is divided inside its outline, unless it has too many corners.
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
  /// Limits the total work for polygons, because dividing one takes cubic time in its corners.
  std::uint64_t steps_left_ = 50'000'000;
};

}  // namespace smurf
