// SPDX-License-Identifier: BSD-3-Clause
// The single rays of a scan, for formats that have no scans.
#pragma once

#include <cstddef>
#include <vector>

#include "convert/sensor_views.hpp"

namespace smurf {

/// Scans with more rays are not supported in such formats.
inline constexpr std::size_t kMostRays = 1000;

/// The number of rays of a scan; 0 if it exceeds kMostRays, or if the direction of the only ray of
/// a fan is unknown.
std::size_t ray_count(const ScanView& scan);

/// The orientation of each ray, whose x axis is its direction: the lowest row first, each row with
/// growing angles about z. ray_count() gives their number.
std::vector<Quaternion> ray_directions(const ScanView& scan);

}  // namespace smurf
