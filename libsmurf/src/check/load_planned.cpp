// SPDX-License-Identifier: BSD-3-Clause
#include "check/load_planned.hpp"

#include <utility>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "check/excuses.hpp"
#include "check/given_arguments.hpp"
#include "link/imported_world.hpp"
#include "link/unused_meshes.hpp"
#include "plan/launched_values.hpp"

namespace smurf {
namespace {

RobotSize size_of(const urdf::Robot& robot) {
  RobotSize size{robot.links.size(), 0};
  for (const urdf::Link& link : robot.links) {
    if (link.inertial) size.mass += link.inertial->mass.value_or(0);
  }
  return size;
}

/// Whether a URDF lies beside the xacro that it was made of, with some values of its arguments:
/// files around the robot may be meant for others.
bool is_made_of_xacro(std::string_view path, const FileReader& files) {
  if (path::extension(path) != ".urdf") return false;
  const std::string whole(path);
  const std::string stem = whole.substr(0, whole.size() - std::string_view(".urdf").size());
  return files.is_file(whole + ".xacro") || files.is_file(stem + ".xacro");
}

/// Whoever has a folder checked has not asked for a URDF of the files of other languages in it.
void calm_losses(std::vector<Diagnostic>& found) {
  for (Diagnostic& one : found) {
    if (one.rule == &rules::sml9304_lost_in_urdf) one.severity = Severity::info;
  }
}

}  // namespace

void PlannedLoader::load(const PlannedFile& planned, const FileReader& files, MeshLibrary& meshes,
                         Outcome& outcome) const {
  const CheckGroup& group = run.memory.groups[planned.config];
  outcome.sources = run.memory.sources;
  DiagnosticSink sink(run.check.limits);
  LoadContext context{outcome.sources,
                      files,
                      sink,
                      run.check.limits,
                      group.packages,
                      settings.package_folders,
                      settings.opens_meshes ? &meshes : nullptr,
                      &group.config.schemas};
  if (run.snapshot != nullptr) {
    context.parsed = &outcome.parsed;
    context.package_search = std::make_shared<PackageSearch>(files);
    seen.tell(*context.package_search->companions);
  } else {
    context.package_search = shared_search;
  }
  context.limits.xacro_steps = xacro_steps;
  context.xacro = group.settings.xacro;
  context.ties = group.ties;
  if (planned.arguments != nullptr && !planned.arguments->values.empty())
    context.xacro.arguments = planned.arguments->values;
  if (is_scene_file(planned.path, files, run.check.limits)) {
    load_one_scene(planned, context, outcome);
  } else {
    load_one_robot(planned, context, outcome);
  }
  for (const auto& [source, expansion] : *context.expansions) {
    outcome.notes.languages.insert(expansion.language);
  }
  if (!planned.is_named) calm_losses(outcome.judged.diagnostics);
  if (!settings.xacro.arguments.empty() || !group.config.xacro.empty()) {
    outcome.notes.arguments = arguments_of(outcome.sources, run.memory.sources.size());
  }
}

void PlannedLoader::load_one_scene(const PlannedFile& planned, LoadContext& context,
                                   Outcome& outcome) const {
  LinkedScene scene = load_scene(planned.path, context);
  load_old_scenes(scene, context);  // for their findings
  outcome.parsed.end_loading(outcome.sources, context.sink);
  outcome.judged = judge(scene, outcome.sources, run.memory.groups[planned.config].selection,
                         context.sink, *context.expansions);
  for (LinkedModel& model : scene.models) take_files(std::move(model), outcome);
  for (const SceneFile& file : scene.scenes) {
    outcome.scenes.insert(identity_of(file.path));
  }
}

void PlannedLoader::load_one_robot(const PlannedFile& planned, LoadContext& context,
                                   Outcome& outcome) const {
  const CheckGroup& group = run.memory.groups[planned.config];
  Accompanied robot = load_robot(planned.path, planned.may_be_part, group.config.xacro, context);
  std::string values;
  if (planned.may_be_part && !robot.model.robot) {
    const auto launched = launched_values(planned.path, context);
    values = describe(launched);
    for (const auto& one : launched) context.xacro.arguments.emplace(one.name, one.value);
    if (!launched.empty()) {
      context.sink.take();  // why the robot needs values
      robot = load_robot(planned.path, planned.may_be_part, group.config.xacro, context);
      report_late_defaults(planned.path, launched, context);
    }
  }
  LinkedModel& model = robot.model;
  if (xacro::is_xacro_file(planned.path) && is_part(model, outcome.sources, planned.may_be_part)) {
    outcome.read.insert(identity_of(model.path));
    return;
  }
  add_surroundings(robot, context);
  if (!robot.companions.checks_first_only) find_unused_meshes(model, context);
  outcome.parsed.end_loading(outcome.sources, context.sink);
  outcome.judged =
      judge(robot, outcome.sources, group.selection, context.sink, *context.expansions);
  const bool is_one_value = !planned.is_named && is_made_of_xacro(planned.path, context.files);
  if (planned.may_be_part || is_one_value) excuse_arguments(outcome.judged.diagnostics);
  const auto excuse = [&](const Companions& companions) {
    const bool may_vary = planned.may_be_part || (has_several_robots && !planned.is_named);
    excuse_names(companions, outcome.sources, may_vary, outcome.judged.diagnostics);
  };
  excuse(robot.companions);
  for (const Variant& one : robot.variants) excuse(one.companions);
  if (has_several_robots) excuse_one_of_several(outcome.judged.diagnostics);
  if (const std::string shown = shown_arguments(planned); !shown.empty()) {
    for (Diagnostic& one : outcome.judged.diagnostics) one.note("with " + shown);
  }
  if (xacro::is_xacro_file(planned.path) && !model.robot) outcome.notes.unknown_robot = model.path;
  if (model.robot) outcome.notes.size = size_of(*model.robot);
  if (!values.empty() && model.robot) {
    outcome.notes.assumption = quoted(model.path) + " with " + values;
  }
  take_companions(robot.companions, model, outcome);
  for (const Variant& one : robot.variants) {
    take_companions(one.companions, one.model, outcome);
  }
  if (planned.is_helper) return keep_asked_for(model, outcome);
  if (!robot.companions.checks_first_only) take_files(std::move(model), outcome);
}

/// Leaves what is about the files for which the robot was loaded.
void PlannedLoader::keep_asked_for(const LinkedModel& model, Outcome& outcome) const {
  const auto is_other = [&](const std::string& file) { return !seen.is_asked_for(file); };
  std::erase_if(outcome.companions, [&](const auto& one) { return is_other(one.first); });
  std::erase_if(outcome.read, is_other);
  std::erase_if(outcome.judged.diagnostics, [&](const Diagnostic& one) {
    return is_other(identity_of(outcome.sources.path(one.span.source)));
  });
  if (!outcome.companions.empty()) outcome.notes.robots_of_srdfs.insert(model.path);
}

void PlannedLoader::take_companions(const Companions& companions, const LinkedModel& model,
                                    Outcome& outcome) const {
  for (const Companion& one : companions.files) {
    const std::string file = identity_of(outcome.sources.path(one.source));
    if (model.robot) outcome.companions.emplace(file, claim_of(one, model));
    // An SRDF without its robot is read, and not compared.
    if (model.robot || !companions.checks_first_only) outcome.read.insert(file);
  }
  for (const SourceId one : companions.surroundings.sources)
    outcome.surroundings.insert(identity_of(outcome.sources.path(one)));
  for (const RejectedCompanion& one : companions.rejected) {
    outcome.notes.rejected.emplace(identity_of(one.path), one);
  }
  if (!companions.checks_first_only) return;
  outcome.notes.robots_of_srdfs.insert(model.robot ? model.path : "");
  // The robot with which it was compared was not asked for.
  std::erase_if(outcome.judged.diagnostics, [&](const Diagnostic& one) {
    return !is_companion_path(outcome.sources.path(one.span.source));
  });
}

void PlannedLoader::take_files(LinkedModel&& model, Outcome& outcome) const {
  outcome.read.insert(*outcome.models.insert(identity_of(model.path)).first);
  for (const ModelFile& file : model.files) {
    outcome.read.insert(identity_of(outcome.sources.path(file.source)));
  }
  if (run.snapshot != nullptr) outcome.parsed.keep(std::move(model));
}

std::string PlannedLoader::identity_of(const std::string& path) const {
  return identity(path, run.check.paths, run.check.files);
}

}  // namespace smurf
