// SPDX-License-Identifier: BSD-3-Clause
// What a selection says of one file, found out once: thousands of findings may ask, and a
// configuration may have a thousand patterns.
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

  /// True when findings of the rule in the file are reported.
  bool is_enabled(const Rule& rule) { return answer(rule).is_enabled; }
  /// The severity that the user has set; none when it is not set.
  std::optional<Severity> severity(const Rule& rule) { return answer(rule).severity; }

 private:
  struct Answer {
    bool is_enabled = true;
    std::optional<Severity> severity;
  };
  const Answer& answer(const Rule& rule);

  const RuleSelection& selection_;
  std::vector<const PathRules*> paths_;  ///< those that cover the file
  std::unordered_map<const Rule*, Answer> answers_;
};

}  // namespace smurf
