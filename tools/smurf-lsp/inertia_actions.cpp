// SPDX-License-Identifier: BSD-3-Clause
// Code actions that write another inertia.
#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lint/inertia_repair.hpp"
#include "smurf-lsp/capabilities.hpp"

namespace smurf::lsp {
namespace {

/// All models of the open documents.
std::vector<const LinkedModel*> models_of(const tools::LoadedNames& names) {
  std::vector<const LinkedModel*> models;
  for (const tools::LoadedNames::Part& part : names.parts()) {
    if (part.model != nullptr) models.push_back(&part.model->model);
    if (part.scene == nullptr) continue;
    for (const LinkedModel& model : part.scene->scene.models) models.push_back(&model);
  }
  return models;
}

/// Those of all models.
const xacro::Expansions& expansions_of(const tools::LoadedNames& names) {
  static const xacro::Expansions kNone;
  for (const tools::LoadedNames::Part& part : names.parts()) {
    if (part.expansions != nullptr) return *part.expansions;
  }
  return kNone;
}

/// "its shapes, filled with 0.5 kg": what a note says after the moments.
std::string assumption_of(const Diagnostic& repair) {
  const std::string& note = repair.notes.front();
  const std::size_t colon = note.find(": ");
  return colon == std::string::npos ? note : note.substr(colon + 2);
}

std::string key_of(const Fix& fix) {
  std::string key;
  for (const Edit& edit : fix.edits) key += std::to_string(edit.span.begin) + "=" + edit.text + ";";
  return key;
}

}  // namespace

std::vector<InertiaAction> inertia_actions(Context& context, const Diagnostic& finding) {
  std::vector<InertiaAction> actions;
  if (!is_repairable(*finding.rule)) return actions;
  Workspace& workspace = context.workspace;
  const tools::LoadedNames& names = workspace.names();
  const std::vector<const LinkedModel*> models = models_of(names);
  const SourceMap& loaded = workspace.loaded_sources();
  const std::string& path = workspace.sources().path(finding.span.source);
  std::set<std::string> known;
  for (const Fix& fix : finding.fixes) known.insert(key_of(fix));
  using From = InertiaSource::From;
  for (const From from : {From::mass, From::box, From::nearest}) {
    const InertiaRepairs found =
        repair_inertias(models, loaded, expansions_of(names), {from, 0},
                        [&](const std::string& file) { return workspace.is_changeable(file); });
    const auto is_at = [&](const Diagnostic& repair, Span place) {
      return repair.rule == finding.rule && loaded.path(repair.span.source) == path &&
             repair.span.begin == place.begin;
    };
    Fix of_all;  // of a finding about several links
    std::size_t count = 0;
    for (const Diagnostic& repair : found.repairs) {
      const Fix& fix = repair.fixes.front();
      const bool is_here = is_at(repair, finding.span);
      const bool is_other =
          std::any_of(finding.labels.begin(), finding.labels.end(),
                      [&](const Label& label) { return is_at(repair, label.span); });
      if (is_here || is_other) {
        ++count;
        of_all.edits.insert(of_all.edits.end(), fix.edits.begin(), fix.edits.end());
      }
      if (!is_here || !known.insert(key_of(fix)).second) continue;
      const bool is_absent = finding.rule->id == std::string_view("SML1505");
      actions.push_back(
          {(is_absent ? "Add the inertia: " : "Replace the inertia: ") + assumption_of(repair),
           fix.edits});
    }
    if (count > 1 && known.insert(key_of(of_all)).second) {
      const std::string source =
          from == From::box ? "the boxes around their shapes" : "their shapes";
      actions.push_back({"Replace " + std::to_string(count) + " inertias: " + source +
                             ", filled with their masses",
                         of_all.edits});
    }
  }
  return actions;
}

}  // namespace smurf::lsp
