// SPDX-License-Identifier: BSD-3-Clause
// Runs the rules over models and scenes.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/linked.hpp"
#include "smurf/readers.hpp"
#include "smurf/references.hpp"

namespace smurf {

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
  /// The severity from the settings, else that of the rule.
  double tolerance_of(const Rule& rule) const;
};
/// True when `pattern` is the rule's id or name, or a prefix of its id.
bool matches(const Rule& rule, std::string_view pattern);

/// The doubtful_references() of a model, found at the first request.
class DoubtfulReferences {
 public:
  /// The list is empty if there is no model.
  explicit DoubtfulReferences(const LinkedModel* model) : model_(model) {}
  std::span<const Reference> list() {
    if (!list_ && model_ != nullptr) list_ = doubtful_references(*model_);
    return list_ ? std::span<const Reference>(*list_) : std::span<const Reference>();
  }

 private:
  const LinkedModel* model_;
  std::optional<std::vector<Reference>> list_;
};

/// Reports the findings of one rule.
class Findings {
 public:
  Findings(const Rule& rule, double tolerance, DiagnosticSink& sink, DoubtfulReferences& references)
      : rule_(rule), tolerance_(tolerance), sink_(sink), references_(references) {}
  Diagnostic& report(Span span, std::string message) {
    return sink_.report(rule_, span, std::move(message));
  }
  /// Marks the finding of another rule at `place` as a fault of this rule, too.
  void add_consequence(Span place) { sink_.add_consequence(place, rule_); }
  /// See DiagnosticSink::suggest().
  std::optional<std::string_view> suggest(std::string_view name,
                                          std::span<const std::string_view> known) {
    return sink_.suggest(name, known);
  }
  /// The doubtful references of the checked model.
  std::span<const Reference> doubtful_references() { return references_.list(); }
  /// Rule::tolerance, or the value from the configuration.
  double tolerance() const { return tolerance_; }

 private:
  const Rule& rule_;
  double tolerance_;
  DiagnosticSink& sink_;
  DoubtfulReferences& references_;
};

void lint_model(const LinkedModel& model, const RuleSelection& selection, DiagnosticSink& sink);
/// Runs the rules about the scene itself; lint_model() checks its models.
void lint_scene(const LinkedScene& scene, const RuleSelection& selection, DiagnosticSink& sink);

/// Fills the pointer of every diagnostic that has none, from the trees of the model or scene.
void locate(const LinkedModel& model, std::span<Diagnostic> diagnostics);
void locate(const LinkedScene& scene, std::span<Diagnostic> diagnostics);

/// Sorts by path, line, column and id, and removes repetitions (a file may belong to two models).
void sort_findings(std::vector<Diagnostic>& diagnostics, const SourceMap& sources);

/// Applies the selection and the targets, then sort_findings(). Diagnostics must
/// be located before, because effects on readers depend on the place. With
/// targets, a finding is an error if a target reports an error, refuses the file
/// or crashes, and a warning if a target silently loses or changes something. If
/// all targets load the file as intended, a finding is one level milder. It keeps
/// its severity if there is no fact about any reader, or if the body is
/// impossible.
std::vector<Diagnostic> finish(std::vector<Diagnostic> diagnostics, const SourceMap& sources,
                               const RuleSelection& selection);

}  // namespace smurf
