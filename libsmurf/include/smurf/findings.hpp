// SPDX-License-Identifier: BSD-3-Clause
// Which rules run, and what a running rule reports into.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "smurf/diagnostic.hpp"

namespace smurf {

class ModelAnswers;

/// Settings for the files that match a pattern.
struct PathRules {
  std::function<bool(const std::string& path)> covers;
  std::vector<std::string> ignore;
  std::map<std::string, Severity> severities;
};

/// The rules to run, and their severities. Ids may be ids, names or prefixes ("SML3").
struct RuleSelection {
  std::vector<std::string> select;  ///< empty: all
  std::vector<std::string> ignore;
  std::map<std::string, Severity> severities;
  std::vector<const Reader*> targets;        ///< empty: no particular reader
  std::map<std::string, double> tolerances;  ///< by id or name
  std::vector<PathRules> paths;              ///< if several match a file, the last one applies

  bool is_enabled(const Rule& rule) const;
  /// The tolerance from the settings, else that of the rule.
  double tolerance_of(const Rule& rule) const;
};
/// True when `pattern` is the rule's id or name, or a prefix of its id.
bool matches(const Rule& rule, std::string_view pattern);

/// Reports the findings of one rule.
class Findings {
 public:
  Findings(const Rule& rule, double tolerance, DiagnosticSink& sink, ModelAnswers& answers)
      : rule_(rule), tolerance_(tolerance), sink_(sink), answers_(answers) {}
  Diagnostic& report(Span span, std::string message) {
    return sink_.report(rule_, span, std::move(message));
  }
  /// Reports one place of a fault that an author or exporter repeats throughout a file. All of them
  /// become one finding, "and 3 more `others` in this file": each is judged, the first is shown.
  /// `habit` tells several habits of the rule apart.
  Diagnostic& report_habit(Span span, std::string message, std::string_view others,
                           std::size_t habit = 0) {
    Diagnostic& finding = report(span, std::move(message));
    finding.others_are = others;
    finding.habit = static_cast<std::uint32_t>(habit);
    return finding;
  }
  /// Marks the finding of another rule at `place` as a fault of this rule, too.
  void add_consequence(Span place) { sink_.add_consequence(place, rule_); }
  /// See DiagnosticSink::suggest().
  std::optional<std::string_view> suggest(std::string_view name,
                                          std::span<const std::string_view> known) {
    return sink_.suggest(name, known);
  }
  /// What other rules may have asked of the same model; of a scene, there are no answers.
  ModelAnswers& answers() { return answers_; }
  /// Rule::tolerance, or the value from the configuration.
  double tolerance() const { return tolerance_; }

 private:
  const Rule& rule_;
  double tolerance_;
  DiagnosticSink& sink_;
  ModelAnswers& answers_;
};

}  // namespace smurf
