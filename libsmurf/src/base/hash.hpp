// SPDX-License-Identifier: BSD-3-Clause
// A hash of bytes that come from a file.
#pragma once

#include <cstddef>
#include <string_view>

namespace smurf {

/// Below 2^32, and another in every run: nobody can write a file whose names all have the same
/// hash, which would make tables of them slow.
std::size_t hash_of(std::string_view bytes);

}  // namespace smurf
