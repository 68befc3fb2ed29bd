// SPDX-License-Identifier: BSD-3-Clause
// Unpacks data in the format of zlib (RFC 1950 and 1951), which PNG contains.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace smurf {

/// None if the data is damaged, cut off, or has more than `most` bytes when unpacked. The checksum
/// is not compared.
std::optional<std::string> inflate_zlib(std::string_view packed, std::uint64_t most);

}  // namespace smurf
