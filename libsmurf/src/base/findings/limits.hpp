// SPDX-License-Identifier: BSD-3-Clause
// The units of limits, and the end of findings about a limit.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "smurf/limits.hpp"

namespace smurf {

/// The cost of a finding in `rechecked-bytes`: as long as reading this many bytes.
inline constexpr std::uint64_t kBytesOfFinding = 1200;

/// The limit `annotation-entries` for files of this size. It is lower if most entries are empty: an
/// entry needs up to 2 kB of memory, but `{},` only three bytes in a file.
inline std::uint64_t most_entries(const Limits& limits, std::uint64_t bytes) {
  constexpr std::uint64_t kFewestBytes = 16;  // bytes of a typical entry
  constexpr std::uint64_t kFree = 50'000;
  const std::uint64_t limit = limits.annotation_entries;
  return std::min(limit, std::max(kFree, limit / 10) + bytes / kFewestBytes);
}

/// `name` is the name of a row of kLimits.
inline std::string raise_limit(std::string_view name) {
  return "raise the limit with `--limit " + std::string(name) + "=N`";
}

}  // namespace smurf
