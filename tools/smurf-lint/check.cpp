// SPDX-License-Identifier: BSD-3-Clause
// Scenes first, then the models no scene has loaded, then the files no model has read: so every
// file is checked in its widest context, and none twice. Within each of the three, files are
// checked in parallel, each with sources of its own, and put together in the order of the plan.
#include "smurf-lint/check.hpp"

#include <algorithm>
#include <iterator>
#include <set>

#include "base/rules.hpp"
#include "common/input.hpp"
#include "common/parallel.hpp"
#include "common/progress.hpp"
#include "common/repository.hpp"
#include "smurf/config.hpp"
#include "smurf/load.hpp"
#include "smurf/suppress.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf::tools {
namespace {

void append(std::vector<Diagnostic>&& from, std::vector<Diagnostic>& to) {
  std::move(from.begin(), from.end(), std::back_inserter(to));
}

void shift(Diagnostic& diagnostic, const SourceShift& by) {
  diagnostic.span = by(diagnostic.span);
  for (Label& label : diagnostic.labels) label.span = by(label.span);
  for (Fix& fix : diagnostic.fixes) {
    for (Edit& edit : fix.edits) edit.span = by(edit.span);
  }
}

/// A configuration and what was found under it.
struct Group {
  Config config;
  Settings settings;
  std::vector<Diagnostic> diagnostics;
  Suppressions suppressions;
};

/// What one planned file, with all that it loads, comes to.
struct Outcome {
  SourceMap sources;
  std::vector<Diagnostic> diagnostics;
  Suppressions suppressions;
  std::set<std::string> models, scenes, read;  ///< by identity
};

/// Checks one file after the other.
class Worker {
 public:
  Worker(const FileReader& files, const Limits& limits,
         const std::vector<std::string>& package_folders)
      : files_(files), limits_(limits), package_folders_(package_folders) {}

  /// `sources` are those of the configurations.
  Outcome check(const std::string& path, const Group& group, const SourceMap& sources) {
    Outcome outcome;
    outcome.sources = sources;
    DiagnosticSink sink(limits_.findings, limits_.suggestions);
    LoadContext context{outcome.sources,         files_,           sink,     limits_,
                        group.settings.packages, package_folders_, &meshes_, &group.config.schemas};
    const InputKind kind = kind_of(path);
    if (kind == InputKind::scene || kind == InputKind::drawing) {
      check_scene(path, group.settings.selection, context, outcome);
    } else {
      check_model(path, group.settings.selection, context, outcome);
    }
    return outcome;
  }

 private:
  static void check_scene(const std::string& path, const RuleSelection& selection,
                          LoadContext& context, Outcome& outcome) {
    const LinkedScene scene = load_scene(path, context);
    lint_scene(scene, selection, context.sink);
    for (const LinkedModel& model : scene.models) {
      lint_model(model, selection, context.sink);
      note_files(model, outcome);
    }
    for (const SceneFile& file : scene.scenes) outcome.scenes.insert(identity(file.path));
    finish(scene, context.sink, outcome);
  }

  static void check_model(const std::string& path, const RuleSelection& selection,
                          LoadContext& context, Outcome& outcome) {
    const LinkedModel model = load_model(path, context);
    lint_model(model, selection, context.sink);
    note_files(model, outcome);
    finish(model, context.sink, outcome);
  }

  template <class Loaded>
  static void finish(const Loaded& loaded, DiagnosticSink& sink, Outcome& outcome) {
    outcome.suppressions.add(loaded, outcome.sources);
    outcome.diagnostics = sink.take();
    locate(loaded, outcome.diagnostics);
  }

  static void note_files(const LinkedModel& model, Outcome& outcome) {
    outcome.models.insert(identity(model.path));
    outcome.read.insert(identity(model.path));
    for (const ModelFile& file : model.files) {
      outcome.read.insert(identity(outcome.sources.path(file.source)));
    }
  }

  const FileReader& files_;
  const Limits& limits_;
  const std::vector<std::string>& package_folders_;
  MeshLibrary meshes_;
};

class Checker {
 public:
  Checker(const LintOptions& options, const FileReader& files, Checked& checked)
      : options_(options),
        files_(files),
        checked_(checked),
        workers_(count_of_jobs(options.jobs), Worker(files, options.limits, package_folders_)) {}

  void configure(const std::vector<std::string>& paths) {
    const std::vector<std::string_view> formats = report_format_names();
    for (const std::string& path : paths) {
      Group& group = groups_.emplace_back();
      DiagnosticSink sink;
      if (!path.empty()) {
        group.config =
            read_config(path, checked_.sources, files_, sink, formats, origin_of_config(options_));
      }
      group.settings = merge(group.config, options_);
      group.diagnostics = sink.take();
      for (const Reader* target : group.settings.selection.targets) {
        auto& all = checked_.targets;
        const auto is_it = [&](const TargetVerdict& one) { return one.reader == target; };
        if (std::none_of(all.begin(), all.end(), is_it)) all.push_back({.reader = target});
      }
    }
    checked_.run = merge_run(groups_.front().config, options_);
    config_sources_ = checked_.sources;
  }

  void check_all(const std::vector<PlannedFile>& planned, Progress& progress) {
    std::vector<const PlannedFile*> left;
    for (const PlannedFile& file : planned) {
      if (!read_.contains(identity(file.path))) {
        left.push_back(&file);
      } else {
        progress.advance();
      }
    }
    std::vector<Outcome> outcomes(left.size());
    for_each_parallel(left.size(), workers_.size(), [&](std::size_t worker, std::size_t i) {
      const Group& group = groups_[left[i]->config];
      outcomes[i] = workers_[worker].check(left[i]->path, group, config_sources_);
      progress.advance();
    });
    for (std::size_t i = 0; i < left.size(); ++i) {
      take(std::move(outcomes[i]), groups_[left[i]->config]);
    }
  }

  void finish_all() {
    std::size_t suppressed = 0;
    std::vector<Diagnostic> all;
    for (Group& group : groups_) {
      const RuleSelection& selection = group.settings.selection;
      std::vector<Diagnostic> found =
          finish(std::move(group.diagnostics), checked_.sources, selection);
      judge(found);
      if (!options_.no_ignores) {
        suppressed += group.suppressions.apply(found, checked_.sources, selection);
        found = finish(std::move(found), checked_.sources, selection);
      }
      append(std::move(found), all);
    }
    sort_findings(all, checked_.sources);
    if (suppressed > 0) note_passed(all, &TargetVerdict::ignored);
    if (!options_.no_ignores && !options_.generate_baseline && !checked_.run.baseline.empty()) {
      suppressed += apply_baseline(all);
      sort_findings(all, checked_.sources);
      note_passed(all, &TargetVerdict::in_baseline);
    }
    checked_.diagnostics = std::move(all);
    checked_.summary = summarize(checked_.diagnostics);
    checked_.summary.suppressed = suppressed;
    checked_.summary.models = models_.size();
    checked_.summary.scenes = scenes_.size();
    checked_.summary.files = count_files();
  }

 private:
  /// What targets make of the findings, before any of them are let pass.
  void judge(const std::vector<Diagnostic>& found) {
    for (TargetVerdict& verdict : checked_.targets) {
      verdict.add(judge_target(*verdict.reader, found));
    }
  }

  /// Of the findings that decide a verdict, those that are not among `left` were let pass.
  void note_passed(const std::vector<Diagnostic>& left, std::size_t TargetVerdict::*counter) {
    for (TargetVerdict& verdict : checked_.targets) {
      const Answer answer = verdict.answer();
      const std::size_t known = verdict.ignored + verdict.in_baseline;
      const std::size_t before = verdict.count(answer) - known;
      const std::size_t after = judge_target(*verdict.reader, left).count(answer);
      if (after < before) verdict.*counter += before - after;
    }
  }

  void take(Outcome&& outcome, Group& group) {
    const SourceShift by =
        checked_.sources.take(std::move(outcome.sources), config_sources_.size());
    for (Diagnostic& diagnostic : outcome.diagnostics) shift(diagnostic, by);
    append(std::move(outcome.diagnostics), group.diagnostics);
    group.suppressions.take(std::move(outcome.suppressions), by);
    models_.merge(outcome.models);
    scenes_.merge(outcome.scenes);
    read_.merge(outcome.read);
  }

  std::size_t apply_baseline(std::vector<Diagnostic>& found) {
    const RuleSelection& selection = groups_.front().settings.selection;
    const std::string& path = checked_.run.baseline;
    DiagnosticSink sink;
    const FileContent content = files_.read(path, options_.limits.file_bytes);
    if (content.status != ReadStatus::ok) {
      sink.report(rules::sml9002_wrong_setting, checked_.run.baseline_place,
                  "cannot read `" + path + "`: " + content.reason)
          .help = "write it with `--generate-baseline`";
      append(finish(sink.take(), checked_.sources, selection), found);
      return 0;
    }
    Baseline baseline(relative_to_folder_of(path));
    const SourceId source = checked_.sources.add(path, content.text);
    if (const auto document = parse_yaml(checked_.sources, source, options_.limits, sink)) {
      baseline.read(*document, sink);
    }
    const std::size_t count = baseline.apply(found, checked_.sources);
    baseline.report_stale(checked_.sources, selection, sink);
    append(finish(sink.take(), checked_.sources, selection), found);
    return count;
  }

  /// A file that two models share is one file.
  std::size_t count_files() const {
    std::set<std::string> paths;
    for (std::size_t i = 0; i < checked_.sources.size(); ++i) {
      const SourceId source{static_cast<std::uint32_t>(i)};
      if (checked_.sources.is_readable(source))
        paths.insert(identity(checked_.sources.path(source)));
    }
    return paths.size();
  }

  const LintOptions& options_;
  const FileReader& files_;
  Checked& checked_;
  const std::vector<std::string> package_folders_ = package_folders_of_environment();
  std::vector<Worker> workers_;
  std::vector<Group> groups_;                     ///< one a configuration of the plan
  SourceMap config_sources_;                      ///< what the sources of each outcome begin with
  std::set<std::string> models_, scenes_, read_;  ///< by identity
};

}  // namespace

Checked check(const LintOptions& options, const Plan& plan, const FileReader& files) {
  Checked checked;
  Checker checker(options, files, checked);
  checker.configure(plan.configs);
  Progress progress("checked", plan.scenes.size() + plan.models.size() + plan.strays.size(),
                    options.quiet);
  for (const auto* planned : {&plan.scenes, &plan.models, &plan.strays}) {
    checker.check_all(*planned, progress);
  }
  checker.finish_all();
  return checked;
}

}  // namespace smurf::tools
