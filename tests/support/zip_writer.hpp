// SPDX-License-Identifier: BSD-3-Clause
// Archives for tests: files stored as they are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace smurf::test {

inline std::uint32_t crc32(std::string_view text) {
  std::uint32_t crc = ~0U;
  for (const char c : text) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return ~crc;
}

inline void append(std::string& bytes, std::uint32_t value, int size) {
  for (int i = 0; i < size; ++i)
    bytes += static_cast<char>(value >> (8U * static_cast<unsigned>(i)) & 0xffU);
}

inline void append_zeros(std::string& bytes, std::size_t count) { bytes.append(count, '\0'); }

/// The common part of both headers of a file, which is stored without compression and time.
inline void append_facts(std::string& bytes, std::string_view name, std::string_view text) {
  append(bytes, 20, 2);    // version
  append_zeros(bytes, 8);  // flags, method, time and date
  append(bytes, crc32(text), 4);
  append(bytes, static_cast<std::uint32_t>(text.size()), 4);
  append(bytes, static_cast<std::uint32_t>(text.size()), 4);
  append(bytes, static_cast<std::uint32_t>(name.size()), 2);
  append(bytes, 0, 2);  // extra field
}

inline std::string zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string bytes;
  std::string directory;
  for (const auto& [name, text] : files) {
    const auto offset = static_cast<std::uint32_t>(bytes.size());
    bytes += "PK\3\4";
    append_facts(bytes, name, text);
    bytes += name + text;
    directory += "PK\1\2";
    append(directory, 20, 2);
    append_facts(directory, name, text);
    append_zeros(directory, 10);  // comment, disk, attributes
    append(directory, offset, 4);
    directory += name;
  }
  const auto start = static_cast<std::uint32_t>(bytes.size());
  bytes += directory + "PK\5\6";
  append(bytes, 0, 4);
  append(bytes, static_cast<std::uint32_t>(files.size()), 2);
  append(bytes, static_cast<std::uint32_t>(files.size()), 2);
  append(bytes, static_cast<std::uint32_t>(directory.size()), 4);
  append(bytes, start, 4);
  append(bytes, 0, 2);
  return bytes;
}

}  // namespace smurf::test
