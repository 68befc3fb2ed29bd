// SPDX-License-Identifier: BSD-3-Clause
// The single rays of a scan, for formats that have no scans.
#pragma once

#include <cstddef>
#include <vector>

#include "convert/sensor_views.hpp"

namespace smurf {

/// A scan with more rays is no thing for such a format.
inline constexpr std::size_t kMostRays = 1000;

/// How many rays a scan has; 0 when there are more than kMostRays, or when the direction of the
/// only ray of a fan is not known.
std::size_t ray_count(const ScanView& scan);

/// The orientation of each ray, whose x axis is its direction: the lowest row first, each row with
/// growing angles about z. ray_count() tells how many.
std::vector<Quaternion> ray_directions(const ScanView& scan);

}  // namespace smurf
