// SPDX-License-Identifier: BSD-3-Clause
// A hash of bytes that come from a file.
#pragma once

#include <cstddef>
#include <string_view>

namespace smurf {

/// A hash below 2^32 that differs from run to run, so nobody can write a file in which all names
/// have the same hash and make tables slow.
std::size_t hash_of(std::string_view bytes);

}  // namespace smurf
