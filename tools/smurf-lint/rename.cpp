// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/rename.hpp"

#include <deque>
#include <set>
#include <utility>
#include <vector>

#include "base/path.hpp"
#include "common/input.hpp"
#include "common/models_around.hpp"
#include "common/output.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/references.hpp"
#include "smurf/rename.hpp"

namespace smurf::tools {
namespace {

constexpr std::string_view kTool = "smurf-lint";

/// What is planned, loaded, and the names in it. Names point into what was loaded.
class LoadedNames {
 public:
  LoadedNames(const LintOptions& options, const LintPlan& plan, Session& session)
      : session_(session), settings_(check_settings(options)) {
    settings_.opens_meshes = false;
    for (const PlannedFile& file : plan.scenes) load_scene(file.path);
    for (const PlannedFile& file : plan.models) load_model(file.path);
    for (const PlannedFile& file : plan.strays) {
      if (!has_read(file.path)) load_model(file.path);
    }
  }

  const std::vector<std::vector<Reference>>& names() const { return names_; }
  /// As a model or scene, or a file of one.
  bool has_read(const std::string& path) const { return read_.contains(identity(path)); }

 private:
  void load_scene(const std::string& path) {
    const LoadedScene& loaded = scenes_.emplace_back(session_.load_scene(path, settings_));
    for (const SceneFile& file : loaded.scene.scenes) read_.insert(identity(file.path));
    for (const LinkedModel& model : loaded.scene.models) note(model);
    names_.push_back(references_of(loaded.scene));
  }

  void load_model(const std::string& path) {
    LoadedModel& loaded = models_.emplace_back(session_.load_model(path, settings_));
    note(loaded.model);
    std::vector<Reference> names = references_of(loaded.model);
    for (const std::string& srdf : srdfs_of(loaded.model)) {
      LoadContext context = session_.context_of(loaded);
      auto document = load_xml(srdf, context);
      if (!document || !is_about(*document, loaded.model)) continue;
      const auto more = references_of(loaded.model, srdfs_.emplace_back(*std::move(document)));
      names.insert(names.end(), more.begin(), more.end());
    }
    names_.push_back(std::move(names));
  }

  void note(const LinkedModel& model) {
    read_.insert(identity(model.path));
    for (const ModelFile& file : model.files) {
      read_.insert(identity(session_.loaded_sources().path(file.source)));
    }
  }

  /// Beside the URDF, or where packages keep them.
  std::vector<std::string> srdfs_of(const LinkedModel& model) const {
    std::vector<std::string> found;
    if (!model.robot) return found;
    const std::string own(path::parent(model.urdf_path));
    for (const std::string& folder :
         {own, path::join(own, "../srdf"), path::join(own, "../config")}) {
      for (const std::string& name : session_.files().list(folder)) {
        if (path::extension(name) == ".srdf") found.push_back(path::join(folder, name));
      }
    }
    return found;
  }

  static bool is_about(const xml::Document& srdf, const LinkedModel& model) {
    const xml::View root = srdf.view();
    const xml::Attribute* name = root ? root.attribute("name") : nullptr;
    return name != nullptr && model.robot->name && name->value() == *model.robot->name;
  }

  Session& session_;
  CheckSettings settings_;
  std::deque<LoadedScene> scenes_;
  std::deque<LoadedModel> models_;
  std::deque<xml::Document> srdfs_;
  std::set<std::string> read_;  ///< by identity
  std::vector<std::vector<Reference>> names_;
};

bool report(std::span<const std::string> problems) {
  for (const std::string& problem : problems) {
    complain(kTool, "nothing was renamed: " + problem);
  }
  return !problems.empty();
}

/// Why a file cannot be written; models that read it and are not renamed with it.
std::vector<std::string> problems_of(const std::string& path, const LoadedNames& loaded,
                                     ModelsAround& around) {
  std::vector<std::string> problems;
  if (!DiskFiles().is_file(path)) {
    problems.push_back("'" + path + "' is in an archive, which is not written");
    return problems;
  }
  for (const std::string& model : around.listing(path)) {
    if (loaded.has_read(model)) continue;
    problems.push_back("'" + model + "' reads '" + path + "' as well; name it, too");
  }
  return problems;
}

}  // namespace

std::optional<std::map<std::string, Change>> rename_all(const LintOptions& options,
                                                        const LintPlan& plan, Session& session) {
  const LoadedNames before(options, plan, session);
  Renamed renamed = rename(before.names(), options.renames, session.loaded_sources());
  if (report(renamed.problems)) return std::nullopt;
  std::map<std::string, Change> changes;
  ModelsAround around(session.files());
  for (FixedText& file : renamed.texts) {
    const bool is_input = file.path == plan.standard_input;
    if (!is_input && report(problems_of(file.path, before, around))) return std::nullopt;
    Change& change = changes[file.path];
    change.before = session.files().read(file.path, options.limits.file_bytes).text;
    change.after = file.text;
  }
  for (FixedText& file : renamed.texts) session.set_text(file.path, std::move(file.text));
  const LoadedNames after(options, plan, session);
  if (report(changed_meanings(before.names(), after.names(), session.loaded_sources()))) {
    return std::nullopt;
  }
  return changes;
}

}  // namespace smurf::tools
