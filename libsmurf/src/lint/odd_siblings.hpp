// SPDX-License-Identifier: BSD-3-Clause
// The one of several links of a kind whose mass or inertia differs from those of all others.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

struct OddSibling {
  const urdf::Link* link;
  const urdf::Link* usual;  ///< one of the others
  std::size_t others;
  double of_mass;  ///< the factor between the masses, at least 1
  double worst;    ///< the largest factor between masses or principal moments
};
/// Those that differ by more than the factor `most`.
std::vector<OddSibling> odd_siblings(const LinkedModel& model, double most);

/// The factor from which on one of several links is no longer like the others.
inline constexpr double kOddFactor = 1.5;

}  // namespace smurf
