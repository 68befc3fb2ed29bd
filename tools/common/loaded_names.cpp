// SPDX-License-Identifier: BSD-3-Clause
#include "common/loaded_names.hpp"

#include <algorithm>
#include <optional>
#include <utility>

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
  for (const PlannedFile& file : plan.scenes) load_scene(file.path);
  for (const PlannedFile& file : plan.models) load_model(file.path);
  for (const PlannedFile& file : plan.strays) {
    if (!has_read(file.path)) load_model(file.path);
  }
}

bool LoadedNames::has_read(const std::string& path) const {
  const std::string wanted = identity(path);
  return std::any_of(parts_.begin(), parts_.end(),
                     [&](const Part& part) { return part.read.contains(wanted); });
}

void LoadedNames::load_scene(const std::string& path) {
  const LoadedScene& loaded = scenes_.emplace_back(session_.load_scene(path, settings_));
  Part& part = parts_.emplace_back(Part{.scene = &loaded});
  for (const SceneFile& file : loaded.scene.scenes) part.read.insert(identity(file.path));
  for (const LinkedModel& model : loaded.scene.models) note(model, part);
  names_.push_back(references_of(loaded.scene));
}

void LoadedNames::load_model(const std::string& path) {
  LoadedModel& loaded = models_.emplace_back(session_.load_model(path, settings_));
  Part& part = parts_.emplace_back(Part{.model = &loaded});
  note(loaded.model, part);
  std::vector<Reference> names = references_of(loaded.model);
  for (const std::string& srdf : srdfs_of(loaded.model)) {
    LoadContext context = session_.context_of(loaded);
    auto document = load_xml(srdf, context);
    if (!document || !is_about(*document, loaded.model)) continue;
    part.srdfs.push_back(&srdfs_.emplace_back(*std::move(document)));
    part.read.insert(identity(srdf));
    const auto more = references_of(loaded.model, srdfs_.back());
    names.insert(names.end(), more.begin(), more.end());
  }
  names_.push_back(std::move(names));
}

void LoadedNames::note(const LinkedModel& model, Part& part) const {
  part.read.insert(identity(model.path));
  for (const ModelFile& file : model.files) {
    part.read.insert(identity(session_.loaded_sources().path(file.source)));
  }
}

/// Beside the URDF, or where packages keep them.
std::vector<std::string> LoadedNames::srdfs_of(const LinkedModel& model) const {
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

}  // namespace smurf::tools
