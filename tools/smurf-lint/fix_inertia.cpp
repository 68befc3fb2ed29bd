// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/fix_inertia.hpp"

#include <algorithm>
#include <utility>

#include "common/output.hpp"
#include "render/printable.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/confine.hpp"
#include "smurf/fix.hpp"

namespace smurf::tools {
namespace {

/// Files that several models read are repaired once.
std::vector<std::string> paths_of(const LintPlan& plan) {
  std::vector<std::string> paths;
  for (const auto* files : {&plan.models, &plan.strays}) {
    for (const PlannedFile& file : *files) {
      const InputKind kind = input_kind(file.path);
      if (kind == InputKind::model || kind == InputKind::urdf) paths.push_back(file.path);
    }
  }
  return paths;
}

}  // namespace

std::map<std::string, Change> fix_inertias(const LintOptions& options, const LintPlan& plan,
                                           Session& session) {
  ConfinedFiles changeable;
  confine_to_changeable(changeable, options, plan);
  const CheckSettings settings = check_settings(options);
  const std::vector<std::string> paths = paths_of(plan);
  session.announce(paths, settings);
  std::map<std::string, Change> changes;
  for (const std::string& path : paths) {
    const LoadedModel loaded = session.load_model(path, settings);
    const SourceMap& sources = session.loaded_sources();
    std::vector<Diagnostic> repairs = repair_inertias(loaded.model, options.inertia);
    std::erase_if(repairs, [&](const Diagnostic& one) {
      const std::string& file = sources.path(one.span.source);
      return changes.contains(file) || (file != plan.standard_input && changeable.is_denied(file));
    });
    for (const Diagnostic& one : repairs) {
      if (options.quiet) break;
      complain(kSmurfLint, render::escape(sources.path(one.span.source)) + ":" +
                               std::to_string(sources.line_of(one.span.source, one.span.begin)) +
                               ": " + render::escape(one.message) + "; " + one.notes.front());
    }
    for (FixedText& file : apply_fixes(repairs, sources, Applicability::unsafe).texts) {
      Change& change = changes[file.path];
      change.before = session.files().read(file.path, options.limits.file_bytes).text;
      change.after = std::move(file.text);
    }
  }
  session.forget_loaded();
  for (const auto& [path, change] : changes) session.set_text(path, change.after);
  return changes;
}

}  // namespace smurf::tools
