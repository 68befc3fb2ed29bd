// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rule_patterns.hpp"

#include <algorithm>
#include <map>

namespace smurf {
namespace {

using Places = std::map<std::string_view, std::size_t>;

/// The indices in the table of rules with these names.
const Places& places_by_name() {
  static const Places places = [] {
    Places all;
    for (std::size_t i = 0; i < all_rules().size(); ++i) {
      all.emplace(all_rules()[i]->name, i);
    }
    return all;
  }();
  return places;
}

}  // namespace

std::span<const Rule* const> rules_matching(std::string_view pattern) {
  const std::span<const Rule* const> rules = all_rules();
  const auto place = places_by_name().find(pattern);
  if (place != places_by_name().end()) return rules.subspan(place->second, 1);
  if (!pattern.starts_with("SML")) return {};
  // Rules are ascending by id, so the rules of a prefix are adjacent.
  const auto first =
      std::lower_bound(rules.begin(), rules.end(), pattern,
                       [](const Rule* rule, std::string_view wanted) { return rule->id < wanted; });
  const auto last = std::find_if(first, rules.end(),
                                 [&](const Rule* rule) { return !rule->id.starts_with(pattern); });
  return {first, last};
}

}  // namespace smurf
