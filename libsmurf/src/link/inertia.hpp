// SPDX-License-Identifier: BSD-3-Clause
// Physics of inertia tensors.
#pragma once

#include <array>
#include <optional>

#include "ast/urdf_attributes.hpp"
#include "smurf/urdf.hpp"

namespace smurf {

/// The six entries, in the order of kInertiaEntries.
inline std::array<const Field<double>*, 6> entries_of(const urdf::Inertial& inertial) {
  return {&inertial.ixx, &inertial.ixy, &inertial.ixz, &inertial.iyy, &inertial.iyz, &inertial.izz};
}
/// Whether all six entries are written, readable or not.
bool is_written(const urdf::Inertial& inertial);
/// Principal moments, ascending, kg m^2; none unless all six entries are readable.
std::optional<std::array<double, 3>> principal_moments(const urdf::Inertial& inertial);

/// Whether all products of inertia are 0.
bool is_diagonal(const urdf::Inertial& inertial);

/// Whether ascending moments are 0, apart from rounding errors that make one of them negative.
inline bool are_zero(const std::array<double, 3>& moments) {
  constexpr double kRounding = 1e-30;  // kg m^2
  return moments[0] <= 0 && moments[0] > -kRounding && moments[2] < kRounding;
}

/// Whether the smallest of ascending moments is positive, apart from rounding errors.
bool is_positive_definite(const std::array<double, 3>& moments);

/// The amount by which the largest of ascending moments exceeds the sum of the others, relative to
/// it; not positive for a possible body.
double triangle_excess(const std::array<double, 3>& moments);
/// A larger excess is not caused by rounding: flat bodies printed with three digits stay below
/// 5e-3, real mistakes are above 1e-2 (5512 inertials of the Tola/Corke dataset).
inline constexpr double kImpossibleExcess = 1e-2;

/// Whether the inertia is the unit tensor, a placeholder of CAD tools and templates.
bool is_unit_tensor(const urdf::Inertial& inertial);

}  // namespace smurf
