// SPDX-License-Identifier: BSD-3-Clause
// The names of an expanded robot, at their places in the xacro files.
#include "smurf/references.hpp"

namespace smurf {
namespace {

std::vector<xacro::Copied> pieces_of(const Reference& one, const xacro::Expansion& expansion) {
  // Escaped characters would change the positions.
  if (one.span.end - one.span.begin != one.name.size()) return {};
  std::vector<xacro::Copied> pieces = expansion.copied_in(one.span);
  for (xacro::Copied& piece : pieces) {
    piece.begin -= one.span.begin;
    piece.end -= one.span.begin;
  }
  return pieces;
}

}  // namespace

void place_in_xacro(const xacro::Expansions& expansions, std::vector<Reference>& references) {
  if (expansions.empty()) return;
  for (Reference& one : references) {
    const auto expansion = expansions.find(one.span.source);
    if (expansion == expansions.end()) continue;
    const xacro::Origin part = expansion->second.origin_of(one.span);
    const xacro::Origin whole = expansion->second.origin_of(one.text);
    one.is_computed = !part.is_exact || !whole.is_exact;
    if (one.is_computed) one.copied = pieces_of(one, expansion->second);
    one.span = part.span;
    one.text = whole.span;
  }
}

}  // namespace smurf
