// SPDX-License-Identifier: BSD-3-Clause
// Which thing of the old version is which of the new one.
#pragma once

#include <vector>

#include "diff/properties.hpp"
#include "diff/renames.hpp"

namespace smurf {

/// By index of the things; kNone: it has no counterpart.
struct Matching {
  std::vector<std::size_t> to_new, to_old;
};

/// By names; then links and joints by the tree, and what is left by what it is. Adds the renames.
Matching match(const Things& before, const Things& after, Renames& renames);

/// Equal for equal properties, whatever their order; of names that are not decided yet, all are
/// equal. 0 for what says nothing.
std::uint64_t hash_of(const Property& property, const Renames& names);

}  // namespace smurf
