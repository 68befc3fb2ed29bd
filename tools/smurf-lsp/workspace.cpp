// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lsp/workspace.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "common/files/input.hpp"
#include "common/rename/planned_rename.hpp"
#include "plan/models_around.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf-lsp/edited_text.hpp"
#include "smurf-lsp/uri.hpp"
#include "smurf/config.hpp"
#include "smurf/confine.hpp"
#include "smurf/found_inputs.hpp"

namespace smurf::lsp {
namespace {

bool is_config(const std::string& path) { return path::file_name(path) == kConfigName; }

/// Whether a change of the file may change the list of checked files.
bool decides_plan(const std::string& path) {
  return is_config(path) || input_kind(path) == InputKind::model;
}

bool is_checkable(const std::string& path, std::string_view text) {
  if (may_be_imported(path)) return is_imported(text);
  switch (input_kind(path)) {
  case InputKind::model:
  case InputKind::scene:
  case InputKind::urdf: return true;
  case InputKind::annotation: return !is_config(path);
  default: return is_companion_path(path);
  }
}

/// What a xacro includes, as it is written.
std::vector<std::string> includes_of(const std::string& path, std::string_view text) {
  std::vector<std::string> includes;
  if (!xacro::is_xacro_file(path)) return includes;
  for (const TextRange one : read_xacro_text(text).includes) {
    includes.emplace_back(one.of(text));
  }
  return includes;
}

/// Selects files as hooks do: excluded files are skipped, and so are YAML files that no model
/// lists.
tools::LintOptions options_for(std::vector<std::string> paths) {
  tools::LintOptions options;
  options.paths = std::move(paths);
  options.only_listed = true;
  options.force_exclude = true;
  return options;
}

/// Adds the views of a model that was loaded alone or with a scene.
void add_views(const LinkedModel& model, const std::string& path, const SourceMap& sources,
               FileView view, std::vector<FileView>& views) {
  view.model = &model;
  for (const ModelFile& file : model.files) {
    if (sources.path(file.source) != path) continue;
    view.source = file.source;
    view.yaml = file.document ? &*file.document : nullptr;
    if (file.kind == ModelFile::Kind::urdf && model.language == Language::xacro) continue;
    const bool is_robot = model.robot && model.robot->document.source == file.source;
    view.xml = is_robot ? &model.robot->document : nullptr;
    views.push_back(view);
  }
}

/// A file of an expanded robot. The elements of the robot are those of the expansion.
void add_xacro_view(const tools::LoadedNames::Part& part, const std::string& path,
                    const SourceMap& sources, FileView view, std::vector<FileView>& views) {
  const LinkedModel& model = part.model->model;
  if (!model.robot) return;
  const auto expansion = part.expansions->find(model.robot->document.source);
  if (expansion == part.expansions->end()) return;
  for (const xml::Document& document : expansion->second.documents) {
    if (sources.path(document.source) != path) continue;
    view.model = &model;
    view.source = document.source;
    view.xml = &document;
    views.push_back(view);
    return;
  }
}

void add_views(const LinkedScene& scene, const std::string& path, const SourceMap& sources,
               FileView view, std::vector<FileView>& views) {
  view.scene = &scene;
  for (const SceneFile& file : scene.scenes) {
    if (!file.document || sources.path(file.source) != path) continue;
    FileView own = view;
    own.source = file.source;
    own.yaml = &*file.document;
    views.push_back(own);
  }
  for (const LinkedModel& model : scene.models) add_views(model, path, sources, view, views);
}

using Files = std::map<std::string, std::string>;  ///< by identity: a path

bool reads_one(const tools::LoadedNames::Part& part, const Files& files) {
  return std::any_of(files.begin(), files.end(), [&](const auto& file) {
    return part.read.contains(file.first) || part.around.contains(file.first);
  });
}

/// The files that contain a name in the models and scenes that read the first file. Other models
/// may also read these files, so the files that contain the name in those models are added.
Files files_to_change(const tools::LoadedNames& loaded, const std::string& first,
                      const Rename& rename, const SourceMap& sources) {
  std::vector<Files> places;  // by part
  for (const std::vector<Reference>& names : loaded.names()) {
    Files& files = places.emplace_back();
    for (const Reference& one : names) {
      const bool is_memory = one.around == Reference::Around::memory;
      if (one.kind != rename.kind || one.name != rename.from || is_memory) continue;
      const std::string& path = sources.path(one.span.source);
      files.emplace(smurf::identity(path), path);
    }
  }
  Files all{{smurf::identity(first), first}};
  for (std::size_t before = 0; before != all.size();) {
    before = all.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (reads_one(loaded.parts()[i], all)) all.insert(places[i].begin(), places[i].end());
    }
  }
  return all;
}

/// The planned models and scenes that read one of the files.
Plan readers_of(const Files& files, const Plan& all, const tools::LoadedNames& loaded) {
  Plan those;
  those.configs = all.configs;
  std::size_t part = 0;
  const auto keep = [&](const std::vector<PlannedFile>& from, std::vector<PlannedFile>& to) {
    for (const PlannedFile& file : from) {
      if (reads_one(loaded.parts()[part++], files)) to.push_back(file);
    }
  };
  keep(all.scenes, those.scenes);
  keep(all.models, those.models);
  for (const PlannedFile& file : all.others) {
    // A robot of xacro may have the name only in files that it includes.
    const auto own =
        std::find_if(loaded.parts().begin(), loaded.parts().end(), [&](const auto& one) {
          return one.model != nullptr && one.model->model.path == path::normalize(file.path);
        });
    const bool reads = own != loaded.parts().end() && reads_one(*own, files);
    if (reads || files.contains(smurf::identity(file.path))) those.others.push_back(file);
  }
  return those;
}

}  // namespace

CheckSettings settings_of_check() {
  CheckSettings settings = tools::check_settings({});
  settings.remembers = true;
  settings.max_seconds = kSecondsInEditor;
  return settings;
}

bool is_same_thing(const Reference& a, const Reference& b) {
  return a.kind == b.kind && a.name == b.name && a.item == b.item && a.model == b.model;
}

void Workspace::set_folders(std::vector<std::string> folders) {
  folders_ = std::move(folders);
  folder_names_.reset();
  folder_session_.reset();
  folder_texts_.clear();
}

void Workspace::touch(const std::string& path) {
  changed_.insert(path);
  is_checked_ = false;
  names_.reset();
  folder_names_.reset();
  xacro_families_.clear();
  reach_ = tools::LoadedNames::Reach::companions;
  looked_around_.clear();
  if (decides_plan(path)) plan_.reset();
}

void Workspace::open(const std::string& path, OpenDocument document) {
  documents_[path] = std::move(document);
  touch(path);
  forget_xacro_files();
  plan_.reset();
}

void Workspace::change(const std::string& path, std::int64_t version, const Json& changes,
                       Encoding encoding) {
  const auto document = documents_.find(path);
  if (document == documents_.end() || !changes.is_array()) return;
  document->second.version = version;
  const std::vector<std::string> before = includes_of(path, document->second.text);
  EditedText text(document->second.text, encoding);
  for (const Json& change : changes) text.apply(change);
  document->second.text = text.text();
  touch(path);
  if (includes_of(path, document->second.text) != before) {
    forget_xacro_files();
    plan_.reset();
  }
}

void Workspace::close(const std::string& path) {
  if (documents_.erase(path) == 0) return;
  robots_about_.clear();
  touch(path);
  forget_xacro_files();
  plan_.reset();
}

void Workspace::forget_files() {
  is_checked_ = false;
  robots_about_.clear();
  names_.reset();
  folder_names_.reset();
  forget_xacro_files();
  plan_.reset();
}

const OpenDocument* Workspace::document(const std::string& path) const {
  const auto found = documents_.find(path);
  return found == documents_.end() ? nullptr : &found->second;
}

std::string Workspace::uri_of(const std::string& path) const {
  const OpenDocument* open = document(path);
  return open != nullptr ? open->uri : uri_of_path(path);
}

void Workspace::put_texts() {
  for (const std::string& path : changed_) {
    const OpenDocument* open = document(path);
    if (open == nullptr) {
      session_.clear_text(path);
    } else {
      session_.set_text(path, open->text);
    }
  }
  changed_.clear();
}

tools::LintPlan Workspace::make_plan(const std::vector<std::string>& paths) const {
  if (paths.empty()) return {};
  const tools::LintOptions options = options_for(paths);
  ConfinedFiles disk;
  tools::confine_to_inputs(disk, options);
  MemoryFiles files(&disk);
  for (const auto& [path, document] : documents_) files.add(path, document.text);
  return tools::make_plan(options, files);
}

std::vector<std::string> Workspace::checkable_documents() const {
  std::vector<std::string> paths;
  for (const auto& [path, document] : documents_) {
    if (is_checkable(path, document.text)) paths.push_back(path);
  }
  return paths;
}

const Plan& Workspace::plan() {
  if (plan_) return *plan_;
  plan_ = make_plan(checkable_documents());
  for (const auto& [path, document] : documents_) {
    auto& configs = plan_->configs;
    if (!is_config(path) || std::find(configs.begin(), configs.end(), path) != configs.end()) {
      continue;
    }
    configs.push_back(path);
  }
  return *plan_;
}

const Report& Workspace::report() {
  if (is_checked_) return report_;
  put_texts();
  report_ = session_.check(plan(), settings_of_check());
  is_checked_ = true;
  return report_;
}

/// The folders in which LoadedNames looks for SRDF files.
std::vector<std::string> Workspace::robots_of_srdfs() const {
  std::vector<std::string> robots;
  for (const auto& [path, document] : documents_) {
    if (path::extension(path) != ".srdf") continue;
    // What is found becomes an input, with a project of its own.
    ConfinedFiles files;
    confine_to_projects(files, std::array{path});
    const std::string own(path::parent(path));
    for (const std::string& folder :
         {own, path::join(own, "../urdf"), path::join(own, "../robots")}) {
      for (const std::string& name : files.list(folder)) {
        const std::string robot = path::join(folder, name);
        if (path::extension(name) == ".urdf" && files.is_file(robot)) robots.push_back(robot);
      }
    }
  }
  return robots;
}

void Workspace::load() {
  session_.forget_loaded();
  Plan all = plan();
  std::vector<std::string> paths = robots_of_srdfs();
  for (const std::string& document : looked_around_) {
    const std::vector<std::string>& robots = robots_about(document);
    paths.insert(paths.end(), robots.begin(), robots.end());
  }
  if (!paths.empty()) {
    for (const std::string& open : checkable_documents()) paths.push_back(open);
    all = make_plan(paths);
  }
  for (const auto& [path, document] : documents_) {
    const bool is_tree = is_checkable(path, document.text) || is_config(path);
    if (is_tree && input_kind(path) != InputKind::scene) all.others.push_back({path, 0});
  }
  CheckSettings settings = settings_of_check();
  settings.opens_meshes = false;
  names_.emplace(all, settings, session_, reach_);
}

const tools::LoadedNames& Workspace::names() {
  if (names_) return *names_;
  put_texts();
  load();
  return *names_;
}

std::vector<FileView> Workspace::views(const std::string& path) {
  std::vector<FileView> found;
  const auto& parts = names().parts();
  const SourceMap& sources = loaded_sources();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const tools::LoadedNames::Part& part = parts[i];
    const FileView view{i};
    if (part.scene != nullptr) {
      add_views(part.scene->scene, path, sources, view, found);
      continue;
    }
    add_views(part.model->model, path, sources, view, found);
    add_xacro_view(part, path, sources, view, found);
    for (const Companion& one : part.companions->files) {
      if (sources.path(one.source) != path) continue;
      found.push_back({i, one.source, &part.model->model, nullptr,
                       one.document ? &*one.document : nullptr,
                       one.srdf ? &one.srdf->document : nullptr});
    }
  }
  std::stable_partition(found.begin(), found.end(),
                        [](const FileView& one) { return one.scene == nullptr; });
  return found;
}

std::vector<FileView> Workspace::views_with(const std::string& path, std::string text) {
  put_texts();
  session_.set_text(path, std::move(text));
  load();
  std::vector<FileView> found = views(path);
  // The loaded files are kept until the next request for them.
  changed_.insert(path);
  return found;
}

std::string Workspace::place_of_definition(std::size_t part, const Reference& reference) {
  for (const Reference& one : names().names()[part]) {
    if (one.is_definition && is_same_thing(one, reference)) {
      return loaded_sources().path(one.span.source);
    }
  }
  return loaded_sources().path(reference.span.source);
}

Plan Workspace::plan_of_rename(const std::string& defined_in, const Rename& rename) {
  std::vector<std::string> paths = checkable_documents();
  paths.insert(paths.end(), folders_.begin(), folders_.end());
  paths.push_back(defined_in);
  ModelsAround around(files());
  for (const std::string& model : around.listing(defined_in)) paths.push_back(model);
  CheckSettings settings = settings_of_check();
  settings.opens_meshes = false;
  while (true) {
    const Plan all = make_plan(paths);
    const tools::LoadedNames loaded(all, settings, session_,
                                    tools::LoadedNames::Reach::surroundings);
    const auto files = files_to_change(loaded, defined_in, rename, session_.loaded_sources());
    const std::size_t before = paths.size();
    for (const auto& [identity, path] : files) {
      for (const std::string& model : around.listing(path)) {
        const bool is_asked_for = std::find(paths.begin(), paths.end(), model) != paths.end();
        if (!is_asked_for && !loaded.has_read(model)) paths.push_back(model);
      }
    }
    if (paths.size() == before) return readers_of(files, all, loaded);
  }
}

void Workspace::confine_changes(ConfinedFiles& changeable) const {
  std::vector<std::string> named = folders_;
  for (const auto& [path, document] : documents_) named.push_back(path);
  confine_to_projects(changeable, named);
}

bool Workspace::is_changeable(const std::string& path) const {
  ConfinedFiles changeable;
  confine_changes(changeable);
  return changeable.is_file(path);
}

Renamed Workspace::rename(std::size_t part, const Reference& reference, const std::string& to) {
  const Rename rename{reference.kind, std::string(reference.name), to};
  const Plan plan = plan_of_rename(place_of_definition(part, reference), rename);
  ConfinedFiles changeable;
  confine_changes(changeable);
  Renamed renamed =
      tools::rename_planned(plan, settings_of_check(), std::span(&rename, 1), session_, changeable);
  for (const FixedText& file : renamed.texts) changed_.insert(file.path);
  put_texts();
  return renamed;
}

}  // namespace smurf::lsp
