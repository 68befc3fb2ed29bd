// SPDX-License-Identifier: BSD-3-Clause
// Classes of the bytes in XML files.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace smurf {

enum ByteClass : std::uint8_t { blank = 1, name_start = 2, name_char = 4, special = 8, colon = 16 };

/// Classes of bytes; the names are those of tinyxml2.
inline constexpr std::array<std::uint8_t, 256> kClasses = [] {
  std::array<std::uint8_t, 256> classes{};
  const auto add = [&](std::string_view bytes, int what) {
    for (const char c : bytes)
      classes[static_cast<unsigned char>(c)] |= static_cast<std::uint8_t>(what);
  };
  add(" \t\n\r", blank);
  add("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_:", name_start | name_char);
  add("0123456789-.", name_char);
  add("\"'<&\r", special);
  add(":", colon);
  for (std::size_t byte = 0x80; byte < 0x100; ++byte) classes[byte] = name_start | name_char;
  return classes;
}();

inline bool is(char c, ByteClass what) {
  return (kClasses[static_cast<unsigned char>(c)] & what) != 0;
}

}  // namespace smurf
