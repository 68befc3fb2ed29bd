// SPDX-License-Identifier: BSD-3-Clause
// The digest of a text, by which texts are told apart: nobody can write two with the same one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace smurf {

/// BLAKE2b of RFC 7693 with 32 bytes and without a key, as `b2sum --length 256` prints it.
using Digest = std::array<std::uint8_t, 32>;
Digest digest_of(std::string_view bytes);

/// The first `bytes` of a digest as hexadecimal digits.
std::string hex_of(const Digest& digest, std::size_t bytes = 32);

/// The first half of the digest of a text, as hexadecimal digits. That is enough: to find two texts
/// with the same one takes 2^64 attempts.
std::string short_digest(std::string_view text);
/// That of the names in a folder.
std::string digest_of_names(const std::vector<std::string>& names);

}  // namespace smurf
