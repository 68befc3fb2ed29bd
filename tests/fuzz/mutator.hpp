// SPDX-License-Identifier: BSD-3-Clause
// Mutations of bundles (bundle.hpp) based on their trees.
#pragma once

#include <string>

#include "unit/random.hpp"

namespace smurf::test {

/// Makes one to three changes of elements, attributes, keys, list entries or files; inserted parts
/// may come from `other` as well. Returns the text unchanged if nothing in it can be parsed, or if
/// the result would be larger than `most` bytes.
std::string mutated_bundle(const std::string& bundle, const std::string& other, std::size_t most,
                           Random& random);

}  // namespace smurf::test
