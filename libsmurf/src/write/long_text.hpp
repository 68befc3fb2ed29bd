// SPDX-License-Identifier: BSD-3-Clause
// Texts of a hundred megabytes.
#pragma once

#include <string>

namespace smurf {

/// To be called before something is added to a text that may become long. A string that doubles to
/// grow is in memory twice, and leaves its old places behind; room that is not used takes none.
inline void make_room(std::string& text) {
  constexpr std::size_t kLong = 8'000'000;
  constexpr std::size_t kRoom = 200'000'000;
  if (text.size() > kLong && text.capacity() < kRoom) text.reserve(kRoom);
}

}  // namespace smurf
