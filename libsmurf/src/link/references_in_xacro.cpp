// SPDX-License-Identifier: BSD-3-Clause
// The names of an expanded robot, at their places in the xacro files.
#include "smurf/references.hpp"

namespace smurf {

void place_in_xacro(const xacro::Expansions& expansions, std::vector<Reference>& references) {
  if (expansions.empty()) return;
  for (Reference& one : references) {
    const auto expansion = expansions.find(one.span.source);
    if (expansion == expansions.end()) continue;
    const xacro::Origin part = expansion->second.origin_of(one.span);
    const xacro::Origin whole = expansion->second.origin_of(one.text);
    one.is_computed = !part.is_exact || !whole.is_exact;
    one.span = part.span;
    one.text = whole.span;
  }
}

}  // namespace smurf
