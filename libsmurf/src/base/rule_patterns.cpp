// SPDX-License-Identifier: BSD-3-Clause
#include "base/rule_patterns.hpp"

#include <algorithm>
#include <unordered_map>

namespace smurf {
namespace {

using Places = std::unordered_map<std::string_view, std::size_t>;

/// Where the rules of these names are in the table.
const Places& places_by_name() {
  static const Places places = [] {
    Places all;
    for (std::size_t i = 0; i < all_rules().size(); ++i) all.emplace(all_rules()[i]->name, i);
    return all;
  }();
  return places;
}

}  // namespace

std::span<const Rule* const> rules_matching(std::string_view pattern) {
  const std::span<const Rule* const> rules = all_rules();
  if (!pattern.starts_with("SML")) {
    const auto place = places_by_name().find(pattern);
    return place == places_by_name().end() ? rules.first(0) : rules.subspan(place->second, 1);
  }
  // Rules are ascending by id, so that those of a prefix are neighbours.
  const auto first =
      std::lower_bound(rules.begin(), rules.end(), pattern,
                       [](const Rule* rule, std::string_view wanted) { return rule->id < wanted; });
  const auto last = std::find_if(first, rules.end(),
                                 [&](const Rule* rule) { return !rule->id.starts_with(pattern); });
  return {first, last};
}

}  // namespace smurf
