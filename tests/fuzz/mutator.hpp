// SPDX-License-Identifier: BSD-3-Clause
// Mutations of bundles (bundle.hpp) that know their trees.
#pragma once

#include <string>

#include "unit/random.hpp"

namespace smurf::test {

/// One to three changes of elements, attributes, keys, list entries or files; what is taken from
/// elsewhere may come from `other` as well. As it was when nothing of it can be read, or when it
/// would be larger than `most` bytes.
std::string mutated_bundle(const std::string& bundle, const std::string& other, std::size_t most,
                           Random& random);

}  // namespace smurf::test
