// SPDX-License-Identifier: BSD-3-Clause
#include "lint/file_selection.hpp"

#include <algorithm>

namespace smurf {
namespace {

void set_severity(const Rule& rule, const std::map<std::string, Severity>& severities,
                  std::optional<Severity>& set) {
  for (const auto& [pattern, severity] : severities) {
    if (matches(rule, pattern)) set = severity;
  }
}

}  // namespace

FileSelection::FileSelection(const RuleSelection& selection, const std::string& path)
    : selection_(selection) {
  for (const PathRules& some : selection.paths) {
    if (some.covers(path)) paths_.push_back(&some);
  }
}

const FileSelection::Answer& FileSelection::answer(const Rule& rule) {
  const auto [known, is_new] = answers_.try_emplace(&rule);
  Answer& answer = known->second;
  if (!is_new) return answer;
  answer.is_enabled = selection_.is_enabled(rule);
  set_severity(rule, selection_.severities, answer.severity);
  for (const PathRules* some : paths_) {
    const auto& ignore = some->ignore;
    answer.is_enabled = answer.is_enabled &&
                        std::none_of(ignore.begin(), ignore.end(), [&](const std::string& pattern) {
                          return matches(rule, pattern);
                        });
    set_severity(rule, some->severities, answer.severity);
  }
  return answer;
}

}  // namespace smurf
