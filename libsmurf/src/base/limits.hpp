// SPDX-License-Identifier: BSD-3-Clause
// What limits count, and how a finding about one ends.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace smurf {

/// The cost of a finding in `rechecked-bytes`: it takes as long as this many bytes.
inline constexpr std::uint64_t kBytesOfFinding = 1200;

/// `name` is that of a row of kLimits.
inline std::string raise_limit(std::string_view name) {
  return "raise the limit with `--limit " + std::string(name) + "=N`";
}

}  // namespace smurf
