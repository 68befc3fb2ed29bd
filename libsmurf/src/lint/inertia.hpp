// SPDX-License-Identifier: BSD-3-Clause
// Physics of inertia tensors.
#pragma once

#include <array>
#include <optional>

#include "smurf/urdf.hpp"

namespace smurf {

/// Principal moments, ascending, kg m^2; none unless all six entries are readable.
std::optional<std::array<double, 3>> principal_moments(const urdf::Inertial& inertial);

/// True when the smallest of ascending moments is positive beyond rounding.
bool is_positive_definite(const std::array<double, 3>& moments);

}  // namespace smurf
