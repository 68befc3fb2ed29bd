// SPDX-License-Identifier: BSD-3-Clause
// Expands xacro files with the files, packages and arguments of a load.
#pragma once

#include <algorithm>
#include <cstdint>

#include "smurf/load.hpp"

namespace smurf {

/// The steps of an expansion that each robot may have, whatever the others take: the largest public
/// robot needs half a million.
inline constexpr std::uint64_t kStepsOfRobot = 600'000;

/// Those of an expansion that only compares: a robot may have hundreds.
constexpr std::uint64_t steps_of_trial(const Limits& limits) {
  constexpr std::uint64_t kTrials = 16;
  return std::min(limits.xacro_steps, std::max(kStepsOfRobot, limits.xacro_steps / kTrials));
}

/// Expands a file that has been read. The robots of a load share its steps.
xacro::Expansion expand_xacro(SourceId root, LoadContext& context);

}  // namespace smurf
