// SPDX-License-Identifier: BSD-3-Clause
// Finds the link, joint or visual at a place of a file.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

namespace smurf {

/// The part whose span contains the byte at `place`; null if there is none. The parts are in the
/// order of the file and do not overlap.
template <class Part>
const Part* part_at(const std::vector<Part>& parts, std::uint32_t place) {
  const auto next = std::partition_point(
      parts.begin(), parts.end(), [&](const Part& part) { return part.span.begin <= place; });
  if (next == parts.begin()) return nullptr;
  const Part& part = *std::prev(next);
  return place < part.span.end ? &part : nullptr;
}

}  // namespace smurf
