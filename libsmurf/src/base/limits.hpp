// SPDX-License-Identifier: BSD-3-Clause
// The units of limits, and the end of findings about a limit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace smurf {

/// The cost of a finding in `rechecked-bytes`: as long as reading this many bytes.
inline constexpr std::uint64_t kBytesOfFinding = 1200;

/// `name` is the name of a row of kLimits.
inline std::string raise_limit(std::string_view name) {
  return "raise the limit with `--limit " + std::string(name) + "=N`";
}

}  // namespace smurf
