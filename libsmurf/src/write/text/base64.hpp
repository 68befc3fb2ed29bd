// SPDX-License-Identifier: BSD-3-Clause
// Binary data in text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace smurf {

std::string base64(std::string_view bytes);

/// Least significant byte first.
template <class Unsigned>
void append_bytes(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    bytes += static_cast<char>(value >> (8 * i) & 0xffU);
  }
}

}  // namespace smurf
