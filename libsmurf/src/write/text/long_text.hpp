// SPDX-License-Identifier: BSD-3-Clause
// Builds texts of a hundred megabytes.
#pragma once

#include <string>

namespace smurf {

/// Call it before appending to a text that may become long. A string that grows by doubling is
/// twice in memory and leaves unused blocks; reserved memory that is not used costs nothing.
inline void make_room(std::string& text) {
  constexpr std::size_t kLong = 8'000'000;
  constexpr std::size_t kRoom = 200'000'000;
  if (text.size() > kLong && text.capacity() < kRoom) text.reserve(kRoom);
}

}  // namespace smurf
