// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/ray_directions.hpp"

namespace smurf {
namespace {

double angle(const RayFan& fan, std::size_t i) {
  return fan.count > 1
             ? fan.lowest + (fan.highest - fan.lowest) * static_cast<double>(i) / (fan.count - 1)
             : fan.lowest;
}

/// Gazebo and gz-sim point the only ray of a fan in different directions unless it is forward.
bool is_known(const RayFan& fan) {
  return fan.count > 1 || (fan.lowest == fan.highest && fan.lowest == 0);
}

}  // namespace

std::size_t ray_count(const ScanView& scan) {
  constexpr double kMost = kMostRays;
  if (!is_known(scan.across) || !is_known(scan.up)) return 0;
  if (!(scan.across.count <= kMost) || !(scan.across.count * scan.up.count <= kMost)) return 0;
  return static_cast<std::size_t>(scan.across.count) * static_cast<std::size_t>(scan.up.count);
}

std::vector<Quaternion> ray_directions(const ScanView& scan) {
  std::vector<Quaternion> directions;
  if (ray_count(scan) == 0) return directions;
  const auto columns = static_cast<std::size_t>(scan.across.count);
  const auto rows = static_cast<std::size_t>(scan.up.count);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      // Positive angles of <vertical> look up, and a positive turn about y looks down.
      const Pose across{{}, from_axis_angle({0, 0, 1}, angle(scan.across, column))};
      const Pose up{{}, from_axis_angle({0, 1, 0}, -angle(scan.up, row))};
      directions.push_back((across * up).orientation);
    }
  }
  return directions;
}

}  // namespace smurf
