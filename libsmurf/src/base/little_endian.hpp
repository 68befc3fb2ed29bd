// SPDX-License-Identifier: BSD-3-Clause
// Little-endian numbers of binary files, at any alignment.
#pragma once

#include <cstdint>
#include <string_view>

#include "base/bits.hpp"

namespace smurf {

/// Precondition: offset + 2 <= bytes.size().
inline std::uint32_t read_uint16(std::string_view bytes, std::size_t offset) {
  return static_cast<unsigned char>(bytes[offset]) |
         std::uint32_t{static_cast<unsigned char>(bytes[offset + 1])} << 8U;
}

/// Precondition: offset + 4 <= bytes.size().
inline std::uint32_t read_uint32(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= std::uint32_t{static_cast<unsigned char>(bytes[offset + i])} << (8 * i);
  }
  return value;
}

inline std::int32_t read_int32(std::string_view bytes, std::size_t offset) {
  return static_cast<std::int32_t>(read_uint32(bytes, offset));
}

inline float read_float(std::string_view bytes, std::size_t offset) {
  return bit_cast<float>(read_uint32(bytes, offset));
}

}  // namespace smurf
