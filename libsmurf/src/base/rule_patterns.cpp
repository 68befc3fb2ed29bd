// SPDX-License-Identifier: BSD-3-Clause
#include "base/rule_patterns.hpp"

#include <algorithm>
#include <map>

namespace smurf {
namespace {

using Places = std::map<std::string_view, std::size_t>;

/// The indices in the table of rules with these names, or with these former ids and names.
const Places& places_by_name() {
  static const Places places = [] {
    Places all;
    for (std::size_t i = 0; i < all_rules().size(); ++i) {
      const Rule& rule = *all_rules()[i];
      all.emplace(rule.name, i);
      for (const std::string_view former : rule.former) all.emplace(former, i);
    }
    return all;
  }();
  return places;
}

}  // namespace

bool has_former(const Rule& rule, std::string_view id_or_name) {
  return std::find(rule.former.begin(), rule.former.end(), id_or_name) != rule.former.end();
}

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
