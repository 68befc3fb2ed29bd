// SPDX-License-Identifier: BSD-3-Clause
// Little-endian numbers of binary files, at any alignment.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>

#include "base/numbers/bits.hpp"

namespace smurf {

/// Precondition: offset + 2 <= bytes.size().
inline std::uint32_t read_uint16(std::string_view bytes, std::size_t offset) {
  return static_cast<unsigned char>(bytes[offset]) |
         std::uint32_t{static_cast<unsigned char>(bytes[offset + 1])} << 8U;
}

/// Precondition: offset + 4 <= bytes.size().
inline std::uint32_t read_uint32(std::string_view bytes, std::size_t offset) {
  unsigned char b[4];
  std::memcpy(b, bytes.data() + offset, sizeof b);  // compilers make one load of it all
  return b[0] | std::uint32_t{b[1]} << 8U | std::uint32_t{b[2]} << 16U | std::uint32_t{b[3]} << 24U;
}

/// Precondition: offset + 8 <= bytes.size().
inline std::uint64_t read_uint64(std::string_view bytes, std::size_t offset) {
  return read_uint32(bytes, offset) | std::uint64_t{read_uint32(bytes, offset + 4)} << 32U;
}

inline std::int32_t read_int32(std::string_view bytes, std::size_t offset) {
  return static_cast<std::int32_t>(read_uint32(bytes, offset));
}

inline float read_float(std::string_view bytes, std::size_t offset) {
  return bit_cast<float>(read_uint32(bytes, offset));
}

}  // namespace smurf
