// SPDX-License-Identifier: BSD-3-Clause
// What each expansion of a run may take: one budget for all robots, variants and files.
#pragma once

#include <algorithm>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include "link/xacro_model.hpp"
#include "smurf/xacro.hpp"

namespace smurf {

/// All share the steps of two, and each file adds those of an honest robot, so that neither the
/// variants of a file nor many files multiply what one may take. The share depends on the plan
/// alone, and not on which robot comes first. `paths` has a file once for each of its variants.
inline std::uint64_t xacro_steps_of_each(const std::vector<std::string_view>& paths,
                                         const Limits& limits) {
  std::set<std::string_view> files;
  std::uint64_t count = 0;
  for (const std::string_view path : paths) {
    if (!xacro::is_xacro_file(path)) continue;
    files.insert(path);
    ++count;
  }
  const std::uint64_t all = 2 * limits.xacro_steps + kStepsOfRobot * files.size();
  return std::min(limits.xacro_steps, all / std::max<std::uint64_t>(count, 1));
}

}  // namespace smurf
