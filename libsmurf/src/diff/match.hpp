// SPDX-License-Identifier: BSD-3-Clause
// Finds the counterparts of things between the old and the new version.
#pragma once

#include <vector>

#include "diff/properties.hpp"
#include "diff/renames.hpp"

namespace smurf {

/// The counterpart of each thing, by index; kNone: there is none.
struct Matching {
  std::vector<std::size_t> to_new, to_old;
};

/// Matches by names, then links and joints by the tree, then the rest by content. Adds the renames.
Matching match(const Things& before, const Things& after, Renames& renames);

/// A hash that ignores the order of properties. All names that are not matched yet are treated as
/// equal. 0 for a thing without content.
std::uint64_t hash_of(const Property& property, const Renames& names);

}  // namespace smurf
