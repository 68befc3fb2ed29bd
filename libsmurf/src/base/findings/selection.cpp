// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/findings.hpp"

#include <algorithm>

#include "smurf/readers.hpp"

namespace smurf {
namespace {

bool matches_any(const Rule& rule, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return matches(rule, pattern); });
}

}  // namespace

bool matches(const Rule& rule, std::string_view pattern) {
  if (pattern == rule.name) return true;
  return pattern.starts_with("SML") && rule.id.starts_with(pattern);
}

bool RuleSelection::is_enabled(const Rule& rule) const {
  if (!select.empty() && !matches_any(rule, select)) return false;
  if (rule.needs_target && std::none_of(targets.begin(), targets.end(), [&](const Reader* reader) {
        return has_facts(*reader, rule);
      })) {
    return false;
  }
  return !matches_any(rule, ignore);
}

double RuleSelection::tolerance_of(const Rule& rule) const {
  for (const auto& [name, tolerance] : tolerances) {
    if (matches(rule, name)) return tolerance;
  }
  return rule.tolerance.value;
}

}  // namespace smurf
