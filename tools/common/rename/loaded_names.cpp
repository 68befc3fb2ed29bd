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

/// The reason why names are missing: a file that a limit keeps from being read; "" if there is
/// none.
std::string unread_file(const Loaded& loaded) {
  for (const Diagnostic& one : loaded.found.diagnostics()) {
    if (one.rule != &rules::sml0002_file_too_large) continue;
    const bool is_whole_file = one.help_text == raise_limit("repeated-bytes") ||
                               one.help_text == raise_limit("file-bytes");
    if (!is_whole_file) continue;
    return loaded.sources->path(one.span.source) + ": " + one.message + "; " + one.help_text;
  }
  return {};
}

}  // namespace

LoadedNames::LoadedNames(const Plan& plan, const CheckSettings& settings, Session& session,
                         Reach reach, Keeps keeps)
    : session_(session), settings_(settings), reach_(reach), keeps_(keeps) {
  std::vector<std::string> paths;
  for (const auto* files : {&plan.scenes, &plan.models, &plan.others}) {
    for (const PlannedFile& file : *files) paths.push_back(file.path);
  }
  session.announce(paths, settings);
  for (const PlannedFile& file : plan.scenes) load_scene(file.path);
  for (const PlannedFile& file : plan.models) load_model(file.path);
  for (const bool are_companions : {false, true}) {
    for (const PlannedFile& file : plan.others) {
      const bool is_turn = is_companion_path(file.path) == are_companions;
      if (is_turn && !has_read(file.path)) load_model(file.path);
    }
  }
}

void LoadedNames::leave(const std::set<std::string>& paths) {
  if (paths.empty()) return;
  const SourceMap& sources = session_.loaded_sources();
  for (std::vector<Reference>& all : names_) {
    std::erase_if(all, [&](const Reference& one) {
      const bool is_around = one.around != Reference::Around::no;
      return is_around && paths.contains(sources.path(one.span.source));
    });
  }
}

bool LoadedNames::has_read(const std::string& path) const { return read_.contains(identity(path)); }

void LoadedNames::finish(std::vector<Reference> names) {
  if (keeps_ == Keeps::names) {
    const SourceMap& sources = session_.loaded_sources();
    for (Reference& one : names) {
      const std::string_view written = sources.text(one.span);
      one.name = written == one.name ? written : texts_.emplace_back(one.name);
    }
    parts_.clear();
    scenes_.clear();
    models_.clear();
    companions_.clear();
    names.shrink_to_fit();
  }
  names_.push_back(std::move(names));
}

void LoadedNames::load_scene(const std::string& path) {
  const LoadedScene& loaded = scenes_.emplace_back(session_.load_scene(path, settings_));
  Part& part = parts_.emplace_back(Part{.scene = &loaded});
  for (const SceneFile& file : loaded.scene.scenes) part.read.insert(identity(file.path));
  for (const LinkedModel& model : loaded.scene.models) note(model, part);
  read_.insert(part.read.begin(), part.read.end());
  if (problem_.empty()) problem_ = unread_file(loaded);
  finish(references_of(loaded.scene));
}

void LoadedNames::load_model(const std::string& path) {
  LoadedModel& loaded = models_.emplace_back(session_.load_model(path, settings_));
  LoadContext context = session_.context_of(loaded);
  context.package_search = search_;
  Companions& companions = companions_.emplace_back();
  if (is_companion_path(path)) {
    Accompanied alone = load_accompanied(path, context);
    loaded.model = std::move(alone.model);
    companions = std::move(alone.companions);
  } else {
    companions = load_companions(loaded.model, context);
  }
  if (reach_ == Reach::surroundings) {
    Accompanied robot{std::move(loaded.model), std::move(companions)};
    add_surroundings(robot, context);
    loaded.model = std::move(robot.model);
    companions = std::move(robot.companions);
  }
  search_ = context.package_search;
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
  if (problem_.empty()) problem_ = unread_file(loaded);
  std::vector<Reference> names = references_of(loaded.model);
  const std::vector<Reference> more = companion_references(loaded.model, companions);
  names.insert(names.end(), more.begin(), more.end());
  for (Reference& one : surrounding_references(loaded.model, companions)) {
    part.around.insert(identity(session_.loaded_sources().path(one.span.source)));
    names.push_back(std::move(one));
  }
  place_in_xacro(*context.expansions, names);
  read_.insert(part.read.begin(), part.read.end());
  finish(std::move(names));
}

void LoadedNames::note(const LinkedModel& model, Part& part) const {
  part.read.insert(identity(model.path));
  for (const ModelFile& file : model.files) {
    part.read.insert(identity(session_.loaded_sources().path(file.source)));
  }
}

}  // namespace smurf::tools
