// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/fix_inertia.hpp"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "common/files/output.hpp"
#include "render/printable.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/confine.hpp"
#include "smurf/fix.hpp"

namespace smurf::tools {
namespace {

/// All models of the plan, also those of scenes.
class Robots {
 public:
  Robots(const LintPlan& plan, const CheckSettings& settings, Session& session) {
    std::vector<std::string> paths;
    for (const PlannedFile& file : plan.scenes) paths.push_back(file.path);
    for (const auto* files : {&plan.models, &plan.others}) {
      for (const PlannedFile& file : *files) {
        const InputKind kind = input_kind(file.path);
        if (kind == InputKind::model || kind == InputKind::urdf) paths.push_back(file.path);
      }
    }
    session.announce(paths, settings);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (i < plan.scenes.size()) {
        const LoadedScene& scene = scenes_.emplace_back(session.load_scene(paths[i], settings));
        for (const LinkedModel& model : scene.scene.models) models_.push_back(&model);
      } else {
        models_.push_back(
            &models_loaded_.emplace_back(session.load_model(paths[i], settings)).model);
      }
      if (expansions_ != nullptr) continue;
      Loaded& first = scenes_.empty() ? static_cast<Loaded&>(models_loaded_.front())
                                      : static_cast<Loaded&>(scenes_.front());
      expansions_ = session.context_of(first).expansions;
    }
  }

  InertiaRepairs repair(const SourceMap& sources, const InertiaSource& source,
                        const std::function<bool(const std::string&)>& may_change) const {
    if (expansions_ == nullptr) return {};
    return repair_inertias(models_, sources, *expansions_, source, may_change);
  }

 private:
  std::deque<LoadedScene> scenes_;
  std::deque<LoadedModel> models_loaded_;
  std::vector<const LinkedModel*> models_;
  std::shared_ptr<const xacro::Expansions> expansions_;  ///< of all
};

/// `place`: the inertia, or the expression to change.
std::string line_about(const Diagnostic& one, Span place, const SourceMap& sources) {
  return render::escape(sources.path(place.source)) + ":" +
         std::to_string(sources.line_of(place.source, place.begin)) + ": " +
         render::escape(one.message) + "; " + render::escape(one.notes.back());
}

/// Whether xacro makes the robots that were meant. Reports one that it does not.
bool proves(const std::map<std::string, std::string>& expanded, const CheckSettings& settings,
            Session& session) {
  for (const auto& [path, text] : expanded) {
    const LoadedExpansion made = session.load_xacro(path, settings);
    if (session.loaded_sources().text(made.expansion.source) == text) continue;
    complain(kSmurfLint, "cannot repair " + render::escape(path) +
                             ": other parts of the robot would change, too; nothing was written");
    return false;
  }
  return true;
}

InertiaRepairs find_repairs(const LintOptions& options, const LintPlan& plan, Session& session) {
  ConfinedFiles changeable;
  confine_to_changeable(changeable, options, plan);
  return Robots(plan, check_settings(options), session)
      .repair(session.loaded_sources(), options.inertia, [&](const std::string& file) {
        return file == plan.standard_input || !changeable.is_denied(file);
      });
}

/// The words of a command that repairs a file.
std::string command_for(const std::string& path) {
  const bool is_plain = path.find_first_of("`'\n") == std::string::npos;
  return is_plain ? "`smurf-lint --fix-inertia '" + path + "'`" : "`smurf-lint --fix-inertia`";
}

}  // namespace

std::vector<Diagnostic> with_inertia_repairs(std::span<const Diagnostic> found,
                                             const LintOptions& options, const LintPlan& plan,
                                             Session& session) {
  std::vector<Diagnostic> all(found.begin(), found.end());
  if (std::none_of(all.begin(), all.end(),
                   [](const Diagnostic& one) { return is_repairable(*one.rule); })) {
    return all;
  }
  const InertiaRepairs repairs = find_repairs(options, plan, session);
  const SourceMap& loaded = session.loaded_sources();
  const SourceMap& sources = session.sources();
  const auto is_at = [&](const Diagnostic& repair, const Rule* rule, Span place) {
    return repair.rule == rule && repair.span.begin == place.begin &&
           repair.span.end == place.end &&
           loaded.path(repair.span.source) == sources.path(place.source);
  };
  for (Diagnostic& one : all) {
    if (!is_repairable(*one.rule)) continue;
    for (const auto* list : {&repairs.repairs, &repairs.refused}) {
      const auto repair_at = [&](Span place) {
        return std::find_if(list->begin(), list->end(),
                            [&](const Diagnostic& each) { return is_at(each, one.rule, place); });
      };
      const auto repair = repair_at(one.span);
      if (repair == list->end()) continue;
      one.note(repair->notes.back());
      if (repair->fixes.empty()) continue;
      one.note(command_for(sources.path(one.span.source)) + " repairs the inertias of this file");
      if (!one.fixes.empty()) continue;
      Fix fix = repair->fixes.front();
      // One finding may be about several links.
      for (const Label& label : one.labels) {
        const auto other = repair_at(label.span);
        if (other == list->end()) continue;
        const std::vector<Edit>& edits = other->fixes.front().edits;
        fix.edits.insert(fix.edits.end(), edits.begin(), edits.end());
      }
      const bool is_here = std::all_of(fix.edits.begin(), fix.edits.end(), [&](const Edit& edit) {
        return loaded.path(edit.span.source) == sources.path(one.span.source);
      });
      if (!is_here) continue;
      for (Edit& edit : fix.edits) edit.span.source = one.span.source;
      one.fixes.push_back(std::move(fix));
    }
  }
  session.forget_loaded();
  return all;
}

std::optional<InertiaChanges> fix_inertias(const LintOptions& options, const LintPlan& plan,
                                           Session& session) {
  const InertiaRepairs found = find_repairs(options, plan, session);
  const SourceMap& sources = session.loaded_sources();
  InertiaChanges changes;
  for (const Diagnostic& one : found.repairs)
    changes.done.push_back(line_about(one, one.span, sources));
  for (const Diagnostic& one : found.refused)
    changes.refused.push_back(line_about(one, one.labels.front().span, sources));
  for (FixedText& file : apply_fixes(found.repairs, sources, Applicability::unsafe).texts) {
    Change& change = changes.files[file.path];
    change.before = session.files().read(file.path, options.limits.file_bytes).text;
    change.after = std::move(file.text);
  }
  session.forget_loaded();
  for (const auto& [path, change] : changes.files) session.set_text(path, change.after);
  const bool is_proved = proves(found.expanded, check_settings(options), session);
  session.forget_loaded();
  return is_proved ? std::optional(std::move(changes)) : std::nullopt;
}

}  // namespace smurf::tools
