// SPDX-License-Identifier: BSD-3-Clause
// Runs the table of rules. Rules see the same immutable model and cannot affect each other.
#include "smurf/lint.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/deadline.hpp"
#include "lint/file_selection.hpp"
#include "lint/model_answers.hpp"
#include "verdict/join.hpp"
#include "verdict/targets.hpp"

namespace smurf {
namespace {

/// Runs this check of all rules that have it.
template <typename Check, typename... Subject>
void run(Check Rule::*check, const LinkedModel* model, const RuleSelection& selection,
         DiagnosticSink& sink, const Subject&... subject) {
  ModelAnswers answers(model);
  for (const Rule* rule : all_rules()) {
    if (rule->*check == nullptr || !selection.is_enabled(*rule)) continue;
    Deadline::look();
    Findings findings(*rule, selection.tolerance_of(*rule), sink, answers);
    (rule->*check)(subject..., findings);
  }
}

/// Diagnostics as people read them: by file, then place, then rule.
auto order_key(const Diagnostic& diagnostic, const SourceMap& sources) {
  return std::tuple<const std::string&, std::uint32_t, std::uint32_t, std::string_view,
                    const std::string&>(sources.path(diagnostic.span.source), diagnostic.span.begin,
                                        diagnostic.span.end, diagnostic.rule->id,
                                        diagnostic.message);
}

/// A deletion removes the whole line when nothing else is on it.
void widen_deletion(Edit& edit, const SourceMap& sources) {
  if (!edit.text.empty() || edit.span.empty()) return;
  const std::string_view text = sources.text(edit.span.source);
  std::uint32_t begin = edit.span.begin;
  while (begin > 0 && (text[begin - 1] == ' ' || text[begin - 1] == '\t')) --begin;
  const std::size_t end = text.find_first_not_of(" \t\r", edit.span.end);
  const bool is_alone =
      begin > 0 && text[begin - 1] == '\n' && end < text.size() && text[end] == '\n';
  if (is_alone) edit.span = {edit.span.source, begin, static_cast<std::uint32_t>(end + 1)};
}

}  // namespace

void lint_model(const LinkedModel& model, const RuleSelection& selection, DiagnosticSink& sink) {
  run(&Rule::check_model, &model, selection, sink, model);
}

void lint_companions(const LinkedModel& model, const Companions& companions,
                     const RuleSelection& selection, DiagnosticSink& sink) {
  run(&Rule::check_companions, &model, selection, sink, model, companions);
}

void lint_scene(const LinkedScene& scene, const RuleSelection& selection, DiagnosticSink& sink) {
  run(&Rule::check_scene, nullptr, selection, sink, scene);
}

void sort_findings(std::vector<Diagnostic>& diagnostics, const SourceMap& sources) {
  std::stable_sort(diagnostics.begin(), diagnostics.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) {
                     return order_key(a, sources) < order_key(b, sources);
                   });
  std::vector<Diagnostic> kept;
  kept.reserve(diagnostics.size());
  for (Diagnostic& one : diagnostics) {
    if (!kept.empty() && order_key(kept.back(), sources) == order_key(one, sources)) {
      join_same(kept.back(), one);
    } else {
      kept.push_back(std::move(one));
    }
  }
  diagnostics = std::move(kept);
}

std::vector<Diagnostic> apply_selection(std::vector<Diagnostic> diagnostics,
                                        const SourceMap& sources, const RuleSelection& selection) {
  std::map<std::string_view, FileSelection> files;  // by path
  const auto file_of = [&](const Diagnostic& one) -> FileSelection& {
    const std::string& path = sources.path(one.span.source);
    return files.try_emplace(path, selection, path).first->second;
  };
  std::erase_if(diagnostics, [&](const Diagnostic& one) {
    const Rule& about = one.left_out == nullptr ? *one.rule : *one.left_out;
    FileSelection& file = file_of(one);
    return !file.is_enabled(*one.rule) || !file.is_enabled(about);
  });
  join_places(diagnostics, sources);
  if (!selection.targets.empty()) apply_targets(diagnostics, selection.targets);
  for (Diagnostic& diagnostic : diagnostics) {
    for (Fix& fix : diagnostic.fixes) {
      for (Edit& edit : fix.edits) widen_deletion(edit, sources);
    }
    const auto severity = file_of(diagnostic).severity(*diagnostic.rule);
    if (severity) diagnostic.severity = *severity;
  }
  sort_findings(diagnostics, sources);
  return diagnostics;
}

}  // namespace smurf
