// SPDX-License-Identifier: BSD-3-Clause
#include "common/loaded_names.hpp"

#include <utility>

#include "base/limits.hpp"
#include "base/path.hpp"
#include "common/input.hpp"
#include "smurf/load.hpp"

namespace smurf::tools {
namespace {

bool is_about(const xml::Document& srdf, const LinkedModel& model) {
  const xml::View root = srdf.view();
  const xml::Attribute* name = root ? root.attribute("name") : nullptr;
  return name != nullptr && model.robot->name && name->value() == *model.robot->name;
}

}  // namespace

LoadedNames::LoadedNames(const Plan& plan, const CheckSettings& settings, Session& session)
    : session_(session), settings_(settings) {
  std::vector<std::string> paths;
  for (const auto* files : {&plan.scenes, &plan.models, &plan.strays}) {
    for (const PlannedFile& file : *files) paths.push_back(file.path);
  }
  session.announce(paths, settings);
  for (const PlannedFile& file : plan.scenes) load_scene(file.path);
  for (const PlannedFile& file : plan.models) load_model(file.path);
  for (const PlannedFile& file : plan.strays) {
    if (!has_read(file.path)) load_model(file.path);
  }
}

bool LoadedNames::has_read(const std::string& path) const { return read_.contains(identity(path)); }

void LoadedNames::release() {
  const SourceMap& sources = session_.loaded_sources();
  for (std::vector<Reference>& names : names_) {
    for (Reference& one : names) one.name = sources.text(one.span);
  }
  parts_.clear();
  scenes_.clear();
  models_.clear();
  srdfs_.clear();
}

void LoadedNames::load_scene(const std::string& path) {
  const LoadedScene& loaded = scenes_.emplace_back(session_.load_scene(path, settings_));
  Part& part = parts_.emplace_back(Part{.scene = &loaded});
  for (const SceneFile& file : loaded.scene.scenes) part.read.insert(identity(file.path));
  for (const LinkedModel& model : loaded.scene.models) note(model, part);
  names_.push_back(references_of(loaded.scene));
  read_.insert(part.read.begin(), part.read.end());
}

void LoadedNames::load_model(const std::string& path) {
  LoadedModel& loaded = models_.emplace_back(session_.load_model(path, settings_));
  Part& part = parts_.emplace_back(Part{.model = &loaded});
  note(loaded.model, part);
  std::vector<Reference> names = references_of(loaded.model);
  if (loaded.model.robot) add_srdfs(loaded, part, names);
  names_.push_back(std::move(names));
  read_.insert(part.read.begin(), part.read.end());
}

void LoadedNames::note(const LinkedModel& model, Part& part) const {
  part.read.insert(identity(model.path));
  for (const ModelFile& file : model.files) {
    part.read.insert(identity(session_.loaded_sources().path(file.source)));
  }
}

/// Adds the names in SRDF files beside the URDF, or in the folders where packages keep them.
void LoadedNames::add_srdfs(LoadedModel& loaded, Part& part, std::vector<Reference>& names) {
  const std::string own(path::parent(loaded.model.urdf_path));
  for (const char* const folder : {".", "../srdf", "../config"}) {
    for (const std::string& path : srdfs_in(path::join(own, folder))) {
      const xml::Document* document = srdf(path, loaded);
      if (document == nullptr || !is_about(*document, loaded.model)) continue;
      if (!part.read.insert(identity(path)).second) continue;
      if (read_.contains(identity(path))) {
        repeated_bytes_ += session_.loaded_sources().text(document->source).size();
      }
      const std::uint64_t most = session_.limits().repeated_bytes;
      if (repeated_bytes_ > most) {
        problem_ = "the models that share SRDF files have more than " + std::to_string(most) +
                   " bytes of them; " + raise_limit("repeated-bytes");
        return;
      }
      part.srdfs.push_back(document);
      const auto more = references_of(loaded.model, *document);
      names.insert(names.end(), more.begin(), more.end());
    }
  }
}

const std::vector<std::string>& LoadedNames::srdfs_in(const std::string& folder) {
  const auto [known, is_new] = folders_of_srdfs_.try_emplace(folder);
  if (!is_new) return known->second;
  for (const std::string& name : session_.files().list(folder)) {
    if (path::extension(name) == ".srdf") known->second.push_back(path::join(folder, name));
  }
  return known->second;
}

/// Reads an SRDF once for all models; null when it cannot be read.
const xml::Document* LoadedNames::srdf(const std::string& path, LoadedModel& loaded) {
  const auto [known, is_new] = srdfs_.try_emplace(path);
  if (is_new) {
    LoadContext context = session_.context_of(loaded);
    known->second = load_xml(path, context);
  }
  return known->second ? &*known->second : nullptr;
}

}  // namespace smurf::tools
