// SPDX-License-Identifier: BSD-3-Clause
// Scenes first, then the models no scene has loaded, then the files no model has read: so every
// file is checked in its widest context, and none twice.
#include "smurf-lint/check.hpp"

#include <iterator>
#include <set>

#include "common/input.hpp"
#include "common/repository.hpp"
#include "smurf/config.hpp"
#include "smurf/load.hpp"
#include "smurf/suppress.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf::tools {
namespace {

/// What the command line says wins over the configuration; both name rules to ignore.
RuleSelection merge(RuleSelection config, const RuleSelection& options) {
  if (!options.select.empty()) config.select = options.select;
  if (!options.targets.empty()) config.targets = options.targets;
  config.ignore.insert(config.ignore.end(), options.ignore.begin(), options.ignore.end());
  for (const auto& [pattern, severity] : options.severities) config.severities[pattern] = severity;
  return config;
}

class Checker {
 public:
  Checker(const LintOptions& options, const FileReader& files, Checked& checked)
      : options_(options), files_(files), checked_(checked), selection_(options.selection) {}

  void configure(const std::string& path) {
    if (path.empty()) return;
    DiagnosticSink sink;
    config_ = read_config(path, checked_.sources, files_, sink);
    selection_ = merge(std::move(config_.selection), options_.selection);
    diagnostics_ = sink.take();
  }

  void check_scene(const std::string& path) {
    DiagnosticSink sink;
    LoadContext context = make_context(sink);
    const LinkedScene scene = load_scene(path, context);
    lint_scene(scene, selection_, sink);
    suppressions_.add(scene, checked_.sources);
    for (const LinkedModel& model : scene.models) {
      lint_model(model, selection_, sink);
      note_files(model);
    }
    for (const SceneFile& file : scene.scenes) scenes_.insert(identity(file.path));
    collect(sink, scene);
  }

  void check_model(const std::string& path) {
    if (read_.contains(identity(path))) return;
    DiagnosticSink sink;
    LoadContext context = make_context(sink);
    const LinkedModel model = load_model(path, context);
    lint_model(model, selection_, sink);
    suppressions_.add(model, checked_.sources);
    note_files(model);
    collect(sink, model);
  }

  void finish_all() {
    std::vector<Diagnostic> found = finish(std::move(diagnostics_), checked_.sources, selection_);
    std::size_t suppressed = 0;
    if (!options_.no_ignores) {
      suppressed = suppressions_.apply(found, checked_.sources, selection_);
      found = finish(std::move(found), checked_.sources, selection_);
      if (!options_.baseline.empty() && !options_.generate_baseline) {
        suppressed += apply_baseline(found);
      }
    }
    checked_.diagnostics = finish(std::move(found), checked_.sources, selection_);
    checked_.summary = summarize(checked_.diagnostics);
    checked_.summary.suppressed = suppressed;
    checked_.summary.models = models_.size();
    checked_.summary.scenes = scenes_.size();
    checked_.summary.files = count_files();
  }

 private:
  std::size_t apply_baseline(std::vector<Diagnostic>& found) {
    DiagnosticSink sink;
    Baseline baseline(relative_to_folder_of(options_.baseline));
    const SourceId source = read_source(options_.baseline);
    if (const auto document = parse_yaml(checked_.sources, source, {}, sink)) {
      baseline.read(*document, sink);
    }
    const std::size_t count = baseline.apply(found, checked_.sources);
    baseline.report_stale(checked_.sources, selection_, sink);
    std::vector<Diagnostic> own = sink.take();
    std::move(own.begin(), own.end(), std::back_inserter(found));
    return count;
  }

  /// Precondition: it can be read; main has seen to that.
  SourceId read_source(const std::string& path) {
    return checked_.sources.add(path, files_.read(path, Limits{}.file_bytes).text);
  }

  LoadContext make_context(DiagnosticSink& sink) {
    return {checked_.sources,  files_,           sink,     {},
            options_.packages, package_folders_, &meshes_, &config_.schemas};
  }

  template <class Loaded>
  void collect(DiagnosticSink& sink, const Loaded& loaded) {
    std::vector<Diagnostic> found = sink.take();
    locate(loaded, found);
    std::move(found.begin(), found.end(), std::back_inserter(diagnostics_));
  }

  void note_files(const LinkedModel& model) {
    models_.insert(identity(model.path));
    read_.insert(identity(model.path));
    for (const ModelFile& file : model.files) {
      read_.insert(identity(checked_.sources.path(file.source)));
    }
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
  MeshLibrary meshes_;
  Config config_;
  RuleSelection selection_;
  std::vector<Diagnostic> diagnostics_;
  Suppressions suppressions_;
  std::set<std::string> models_, scenes_, read_;  ///< by identity
};

}  // namespace

Checked check(const LintOptions& options, const Plan& plan, const FileReader& files) {
  Checked checked;
  Checker checker(options, files, checked);
  checker.configure(plan.config);
  for (const std::string& path : plan.scenes) checker.check_scene(path);
  for (const std::string& path : plan.models) checker.check_model(path);
  for (const std::string& path : plan.strays) checker.check_model(path);
  checker.finish_all();
  return checked;
}

}  // namespace smurf::tools
