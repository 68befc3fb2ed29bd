// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "base/files/path.hpp"
#include "common/files/input.hpp"
#include "common/files/output.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/companions.hpp"
#include "smurf/confine.hpp"
#include "smurf/found_inputs.hpp"
#include "smurf/lint.hpp"

namespace smurf::load_check {
namespace {

using namespace smurf::tools;

constexpr std::string_view kTool = "smurf-load-check";

/// Rules of file readers, and rules whose faults leave no robot to
/// build.
bool is_about_building(const Rule& rule) { return rule.blocks_building || !rule.has_check(); }

/// Unreadable numbers, broken files and scenes, but not faults of annotations.
bool is_obstacle(const Diagnostic& diagnostic) {
  const std::string_view family = diagnostic.rule->id.substr(0, 4);
  return family == "SML0" || family == "SML1" || family == "SML2" || family == "SML5";
}

/// Comments and configurations have no influence on whether a robot can be built.
CheckSettings settings_for(const InputOptions& options) {
  CheckSettings settings;
  settings.is_isolated = true;
  settings.opens_meshes = false;
  settings.heeds_comments = false;
  settings.heeds_baseline = false;
  settings.packages = options.packages;
  settings.max_seconds = options.max_seconds;
  settings.xacro = options.xacro;
  return settings;
}

bool is_scene(InputKind kind) { return kind == InputKind::scene || kind == InputKind::drawing; }

class Loader {
 public:
  Loader(const InputOptions& options, Inputs& inputs) : options_(options), inputs_(inputs) {}

  void run() {
    confine(inputs_.disk, std::span(&options_.stdin_filename, 1), {}, options_.allow_outside);
    std::vector<std::string> files;
    const std::vector<std::string> here{"."};
    const std::vector<std::string>& paths = options_.paths.empty() ? here : options_.paths;
    confine(inputs_.disk, paths, options_.packages, options_.allow_outside);
    for (const std::string& path : paths) {
      find(path, files);
    }
    // Starting with the widest context: scenes, models, then URDFs that no model has read.
    const auto rank = [](const std::string& file) {
      const InputKind kind = input_kind(file);
      return is_scene(kind) ? 0 : kind == InputKind::model ? 1 : 2;
    };
    std::stable_sort(files.begin(), files.end(),
                     [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
    for (const std::string& file : files) load(file);
  }

 private:
  void fail(const std::string& message) {
    complain(kTool, message);
    inputs_.has_failed = true;
  }

  void find(const std::string& path, std::vector<std::string>& files) {
    std::error_code ignored;
    if (path == "-") {
      const auto name =
          read_standard_input(kTool, options_.stdin_filename, options_.limits, inputs_.files);
      inputs_.has_failed = inputs_.has_failed || !name;
      if (name) files.push_back(*name);
    } else if (std::filesystem::is_directory(path, ignored)) {
      FoundInputs found = find_inputs(path, options_.limits);
      std::erase_if(found.files, [](const std::string& one) { return is_companion_path(one); });
      if (is_shared_folder(path)) {
        confine(inputs_.disk, found.files, options_.packages, options_.allow_outside);
      }
      for (const std::string& problem : found.unreadable) fail("cannot read " + problem);
      if (found.files.empty() && found.unreadable.empty()) {
        fail(why_nothing(found, path));
      }
      files.insert(files.end(), found.files.begin(), found.files.end());
    } else if (const auto main = find_main_file(kTool, path, inputs_.files); !main) {
      inputs_.has_failed = true;
    } else if (is_archive(path)) {
      files.push_back(*main);
    } else if (input_kind(path) == InputKind::annotation || input_kind(path) == InputKind::other) {
      fail("cannot check '" + path +
           "': it is not a .smurf, .smurfs, .smurfa, .svg, .urdf or .xacro file");
    } else {
      files.push_back(path);
    }
  }

  /// A model alone counts as a scene of one entity.
  void load(const std::string& file) {
    if (!done_.insert(identity(file, inputs_.files)).second) return;
    LoadedScene& loaded =
        inputs_.scenes.emplace_back(inputs_.session.load_scene(file, settings_for(options_)));
    const LinkedScene& scene = loaded.scene;
    for (const LinkedModel& model : scene.models) {
      done_.insert(identity(model.path, inputs_.files));
      if (!model.urdf_path.empty()) done_.insert(identity(model.urdf_path, inputs_.files));
    }
    std::vector<Diagnostic> found = inputs_.session.check(loaded).diagnostics;
    std::erase_if(found, [&](const Diagnostic& diagnostic) {
      return diagnostic.severity != Severity::error || !is_about_building(*diagnostic.rule) ||
             (!is_obstacle(diagnostic) && !leaves_no_robot(scene, diagnostic));
    });
    add_jobs(file, loaded, std::move(found));
  }

  /// A finding that prevents checks is reported by the first job that it prevents.
  void add_jobs(const std::string& file, const LoadedScene& loaded, std::vector<Diagnostic> found) {
    const LinkedScene& scene = loaded.scene;
    const bool has_scene = is_scene(input_kind(file));
    const bool is_sound = found.empty();
    for (const LinkedModel& model : scene.models) {
      Job job{.path = model.path,
              .model = &model,
              .scene = nullptr,
              .loaded = &loaded,
              .obstacles = {}};
      const auto of_model =
          std::stable_partition(found.begin(), found.end(), [&](const Diagnostic& diagnostic) {
            return !concerns(model, diagnostic);
          });
      job.obstacles.assign(of_model, found.end());
      found.erase(of_model, found.end());
      if (model.robot || !job.obstacles.empty()) inputs_.jobs.push_back(std::move(job));
    }
    if (!has_scene && found.empty()) return;
    Job job{.path = file,
            .model = nullptr,
            .scene = &scene,
            .loaded = &loaded,
            .obstacles = std::move(found)};
    if (is_sound || !job.obstacles.empty()) inputs_.jobs.push_back(std::move(job));
  }

  /// Any error in a model without a URDF: there is nothing to build.
  static bool leaves_no_robot(const LinkedScene& scene, const Diagnostic& diagnostic) {
    return std::any_of(scene.models.begin(), scene.models.end(), [&](const LinkedModel& model) {
      return !model.robot && concerns(model, diagnostic);
    });
  }

  static bool concerns(const LinkedModel& model, const Diagnostic& diagnostic) {
    return std::any_of(model.files.begin(), model.files.end(), [&](const ModelFile& file) {
      return file.source == diagnostic.span.source;
    });
  }

  const InputOptions& options_;
  Inputs& inputs_;
  std::set<std::string> done_;  ///< by identity
};

}  // namespace

void load_inputs(const InputOptions& options, Inputs& inputs) { Loader(options, inputs).run(); }

}  // namespace smurf::load_check
