// SPDX-License-Identifier: BSD-3-Clause
// Sums over the triangles of a mesh, independent of their order, for comparing two readers.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include "smurf/pose.hpp"

namespace smurf::test {

struct ShapeSums {
  std::size_t triangles = 0;
  double area = 0;
  Vector3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  Vector3 moment{};       ///< of the area
  Vector3 area_vector{};  ///< its sign shows which way the triangles face

  void add(const Vector3& a, const Vector3& b, const Vector3& c) {
    ++triangles;
    Vector3 u;
    Vector3 v;
    for (std::size_t i = 0; i < 3; ++i) {
      u[i] = b[i] - a[i];
      v[i] = c[i] - a[i];
      low[i] = std::fmin(low[i], std::fmin(a[i], std::fmin(b[i], c[i])));
      high[i] = std::fmax(high[i], std::fmax(a[i], std::fmax(b[i], c[i])));
    }
    const Vector3 n{(u[1] * v[2] - u[2] * v[1]) / 2, (u[2] * v[0] - u[0] * v[2]) / 2,
                    (u[0] * v[1] - u[1] * v[0]) / 2};
    const double size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    area += size;
    for (std::size_t i = 0; i < 3; ++i) {
      area_vector[i] += n[i];
      moment[i] += size * (a[i] + b[i] + c[i]) / 3;
    }
  }

  /// Empty when both are the same within single precision.
  std::string difference(const ShapeSums& other) const {
    if (triangles != other.triangles) {
      return std::to_string(triangles) + " and " + std::to_string(other.triangles) + " triangles";
    }
    double reach = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      reach = std::fmax(reach, std::fmax(std::fabs(low[i]), std::fabs(high[i])));
    }
    constexpr double kPrecision = 1e-4;
    const auto differ = [&](double a, double b, double scale) {
      return !(std::fabs(a - b) <= kPrecision * scale);
    };
    if (differ(area, other.area, reach * reach)) {
      return "areas differ: " + std::to_string(area) + ", " + std::to_string(other.area);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (differ(low[i], other.low[i], reach) || differ(high[i], other.high[i], reach)) {
        return "boxes differ: " + std::to_string(low[i]) + " to " + std::to_string(high[i]) + ", " +
               std::to_string(other.low[i]) + " to " + std::to_string(other.high[i]);
      }
      if (differ(area_vector[i], other.area_vector[i], reach * reach)) return "sides differ";
      if (differ(moment[i], other.moment[i], reach * reach * reach)) return "centroids differ";
    }
    return {};
  }
};

}  // namespace smurf::test
