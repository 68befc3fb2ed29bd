// SPDX-License-Identifier: BSD-3-Clause
// Evaluates a selection once per file: there may be thousands of findings, and a configuration may
// have a thousand patterns.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "smurf/lint.hpp"

namespace smurf {

class FileSelection {
 public:
  /// The selection must outlive it.
  FileSelection(const RuleSelection& selection, const std::string& path);

  /// Whether findings of the rule in the file are reported.
  bool is_enabled(const Rule& rule) { return answer(rule).is_enabled; }
  /// The severity set by the user; none if it is not set.
  std::optional<Severity> severity(const Rule& rule) { return answer(rule).severity; }

 private:
  struct Answer {
    bool is_enabled = true;
    std::optional<Severity> severity;
  };
  const Answer& answer(const Rule& rule);

  const RuleSelection& selection_;
  std::vector<const PathRules*> paths_;  ///< settings that match the file
  std::unordered_map<const Rule*, Answer> answers_;
};

}  // namespace smurf
