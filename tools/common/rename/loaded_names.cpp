// SPDX-License-Identifier: BSD-3-Clause
#include "common/rename/loaded_names.hpp"

#include <algorithm>
#include <utility>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "common/files/input.hpp"
#include "smurf/load.hpp"

namespace smurf::tools {
namespace {

/// Whether companions are missing because too many bytes were read again.
bool lacks_companions(const LoadedModel& loaded, const SourceMap& sources) {
  const auto& found = loaded.found.diagnostics();
  return std::any_of(found.begin(), found.end(), [&](const Diagnostic& one) {
    return one.rule == &rules::sml0002_file_too_large &&
           is_companion_path(sources.path(one.span.source));
  });
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
  for (const bool are_companions : {false, true}) {
    for (const PlannedFile& file : plan.strays) {
      const bool is_turn = is_companion_path(file.path) == are_companions;
      if (is_turn && !has_read(file.path)) load_model(file.path);
    }
  }
}

bool LoadedNames::has_read(const std::string& path) const { return read_.contains(identity(path)); }

void LoadedNames::release() {
  const SourceMap& sources = session_.loaded_sources();
  for (std::vector<Reference>& names : names_) {
    for (Reference& one : names) {
      one.name = one.is_computed ? computed_.emplace_back(one.name) : sources.text(one.span);
    }
  }
  parts_.clear();
  scenes_.clear();
  models_.clear();
  companions_.clear();
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
  LoadContext context = session_.context_of(loaded);
  Companions& companions = companions_.emplace_back();
  if (is_companion_path(path)) {
    Accompanied alone = load_accompanied(path, context);
    loaded.model = std::move(alone.model);
    companions = std::move(alone.companions);
  } else {
    companions = load_companions(loaded.model, context);
  }
  Part& part = parts_.emplace_back(
      Part{.model = &loaded, .companions = &companions, .expansions = context.expansions});
  note(loaded.model, part);
  const auto note_included = [&](SourceId source) {
    const auto expansion = context.expansions->find(source);
    if (expansion == context.expansions->end()) return;
    for (const std::string& file : expansion->second.included) part.read.insert(identity(file));
  };
  if (loaded.model.robot) note_included(loaded.model.robot->document.source);
  for (const Companion& one : companions.files) {
    part.read.insert(identity(session_.loaded_sources().path(one.source)));
    if (one.srdf) note_included(one.srdf->document.source);
  }
  if (lacks_companions(loaded, session_.loaded_sources())) {
    problem_ = "the models that share SRDF files have more than " +
               std::to_string(session_.limits().repeated_bytes) + " bytes of them; " +
               raise_limit("repeated-bytes");
  }
  std::vector<Reference> names = references_of(loaded.model);
  const std::vector<Reference> more = companion_references(loaded.model, companions);
  names.insert(names.end(), more.begin(), more.end());
  place_in_xacro(*context.expansions, names);
  names_.push_back(std::move(names));
  read_.insert(part.read.begin(), part.read.end());
}

void LoadedNames::note(const LinkedModel& model, Part& part) const {
  part.read.insert(identity(model.path));
  for (const ModelFile& file : model.files) {
    part.read.insert(identity(session_.loaded_sources().path(file.source)));
  }
}

}  // namespace smurf::tools
