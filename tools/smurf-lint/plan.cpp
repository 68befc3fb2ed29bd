// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/plan.hpp"

#include <filesystem>
#include <set>

#include "base/path.hpp"
#include "common/discover.hpp"
#include "common/input.hpp"
#include "smurf/config.hpp"

namespace smurf::tools {
namespace {

constexpr std::string_view kTool = "smurf-lint";

class Planner {
 public:
  Planner(const LintOptions& options, MemoryFiles& files) : options_(options), files_(files) {}

  Plan run() {
    std::vector<std::string> paths = options_.paths;
    if (paths.empty()) paths.emplace_back(".");
    find_config(paths.front() == "-" ? options_.stdin_filename : paths.front());
    for (const std::string& path : paths) {
      std::error_code ignored;
      if (path == "-") {
        add_standard_input();
      } else if (std::filesystem::is_directory(path, ignored)) {
        add_folder(path);
      } else {
        add_named(path);
      }
    }
    return std::move(plan_);
  }

 private:
  void find_config(const std::string& path) {
    if (options_.isolated) return;
    if (!options_.config.empty()) {
      plan_.config = options_.config;
      const auto reason = why_unreadable(plan_.config, files_);
      if (reason) fail("cannot read '" + plan_.config + "': " + *reason);
      if (reason) plan_.config.clear();
      return;
    }
    std::error_code ignored;
    const bool is_folder = std::filesystem::is_directory(path, ignored);
    std::string folder(is_folder ? path : std::string(path::parent(path)));
    const auto absolute = std::filesystem::absolute(folder.empty() ? "." : folder, ignored);
    for (auto level = std::distance(absolute.begin(), absolute.end()); level > 0; --level) {
      const std::string config = path::join(folder, kConfigName);
      if (files_.is_file(config)) {
        plan_.config = config;
        return;
      }
      folder = path::join(folder, "..");
    }
  }

  void fail(const std::string& message) {
    complain(kTool, message);
    plan_.has_failed = true;
  }

  void add(std::vector<std::string>& to, const std::string& path) {
    if (planned_.insert(identity(path)).second) to.push_back(path);
  }

  void add_standard_input() {
    const auto name = read_standard_input(kTool, options_.stdin_filename, files_);
    if (!name) {
      plan_.has_failed = true;
      return;
    }
    plan_.standard_input = *name;
    add_file(*name);
  }

  void add_folder(const std::string& folder) {
    const Found found = find_inputs(folder);
    for (const std::string& problem : found.unreadable) fail("cannot read " + problem);
    if (found.files.empty() && found.unreadable.empty()) {
      fail("no .smurf, .smurfs, .smurfa or .urdf file in '" + folder + "'");
    }
    for (const std::string& file : found.files) {
      switch (kind_of(file)) {
      case InputKind::scene: add(plan_.scenes, file); break;
      case InputKind::urdf: add(plan_.strays, file); break;
      default: add(plan_.models, file); break;
      }
    }
  }

  void add_named(const std::string& path) {
    if (const auto reason = why_unreadable(path, files_)) {
      fail("cannot read '" + path + "': " + *reason);
    } else {
      add_file(path);
    }
  }

  void add_file(const std::string& path) {
    switch (kind_of(path)) {
    case InputKind::scene: add(plan_.scenes, path); return;
    case InputKind::model: add(plan_.models, path); return;
    case InputKind::urdf:
    case InputKind::annotation: add_part(path); return;
    case InputKind::resource: add_resource(path); return;
    case InputKind::other: break;
    }
    const bool is_xacro = path::to_lower(path::extension(path)) == ".xacro";
    fail("cannot check '" + path + "': " +
         (is_xacro ? "expand it first: xacro FILE | smurf-lint -"
                   : "it is no .smurf, .smurfs, .smurfa, .urdf or .yml file"));
  }

  void add_part(const std::string& path) {
    const std::vector<std::string> models = models_listing(path, files_);
    for (const std::string& model : models) add(plan_.models, model);
    const bool is_left_out = options_.only_listed && kind_of(path) == InputKind::annotation;
    if (models.empty() && !is_left_out) add(plan_.strays, path);
  }

  void add_resource(const std::string& path) {
    const std::vector<std::string> models = models_using(path, files_);
    for (const std::string& model : models) add(plan_.models, model);
    if (models.empty() && !options_.only_listed) fail("no model near '" + path + "' uses it");
  }

  const LintOptions& options_;
  MemoryFiles& files_;
  Plan plan_;
  std::set<std::string> planned_;
};

}  // namespace

Plan make_plan(const LintOptions& options, MemoryFiles& files) {
  return Planner(options, files).run();
}

}  // namespace smurf::tools
