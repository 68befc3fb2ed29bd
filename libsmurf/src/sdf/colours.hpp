// SPDX-License-Identifier: BSD-3-Clause
// The colours of the materials that Gazebo knows by name.
#pragma once

#include <optional>
#include <string_view>

#include "smurf/pose.hpp"

namespace smurf::sdformat {

/// Red, green and blue from 0 to 1 of `Gazebo/Red`; none for a name that is not known, and for a
/// material with a picture.
std::optional<Vector3> colour_of(std::string_view name);

}  // namespace smurf::sdformat
