// SPDX-License-Identifier: BSD-3-Clause
// Checks a scene, and writes it in a format.
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/edits.hpp"
#include "check/in_time.hpp"
#include "check/pipeline.hpp"
#include "conversion/floor.hpp"
#include "conversion/joint_controllers.hpp"
#include "conversion/judged_models.hpp"
#include "conversion/own_contacts.hpp"
#include "conversion/refusal.hpp"
#include "conversion/replaced_collisions.hpp"
#include "conversion/scene_assets.hpp"
#include "link/imported_world.hpp"
#include "smurf/conversion.hpp"
#include "smurf/result_losses.hpp"
#include "write/parts/body_inertia.hpp"

namespace smurf {
namespace {

/// True when a robot is free to move and nothing in the scene could be a floor.
bool has_falling_robots(const FlatScene& flat) {
  const auto is_fixed_thing = [](const FlatInstance& instance) {
    return !instance.model && !instance.shapes.empty();
  };
  const auto is_free = [](const FlatInstance& instance) {
    return instance.model && instance.anchor.kind == Attachment::Kind::none;
  };
  return std::any_of(flat.instances.begin(), flat.instances.end(), is_free) &&
         std::none_of(flat.instances.begin(), flat.instances.end(), is_fixed_thing);
}

/// Why a finding of loading would make the result wrong; with `force`, only what cannot be forced.
/// A comment suppresses the finding, but does not make the value known.
std::string first_loss(const LoadedScene& loaded, bool force) {
  std::vector<Diagnostic> errors;
  for (const Diagnostic& finding : loaded.found.diagnostics()) {
    if (finding.severity != Severity::error) continue;
    if (!is_about_missing_part(finding)) errors.push_back(finding);  // the rest is known
  }
  if (errors.empty()) return {};
  for (const Diagnostic& finding : placed(loaded.scene, std::move(errors))) {
    if (force && can_be_forced(finding)) continue;
    if (const auto loss = loss_in_scene(finding, loaded.scene, *loaded.sources)) return *loss;
  }
  return {};
}

/// Whether an unknown key may be a misspelt `entities`. Scenes can be empty on purpose.
bool lacks_entities(const LinkedScene& scene) {
  const SceneFile& file = scene.scenes.front();
  if (!scene.instances.empty() || file.scene.extra.empty() || !file.document) return false;
  const yaml::View root = file.document->view();
  return !root.find("entities") && !root.find("smurfs") && !root.find("smurfa");
}

/// Whether readers of the result would look for files of models that were made from a world. JSON
/// names them for programs that know it.
bool names_made_models(const LinkedScene& scene, const SceneRequest& request) {
  return request.form == SceneForm::reference && request.format.name != "json" &&
         std::any_of(scene.models.begin(), scene.models.end(),
                     [](const LinkedModel& model) { return !name_in_world(model.path).empty(); });
}

/// The scene as a table, in a dialect; none, with a finding, if it is too large.
std::optional<FlatScene> flat_scene(LoadedScene& loaded, const Dialect& dialect,
                                    FlattenOptions options, const Limits& limits) {
  SceneReading reading;
  if (&dialect != dialects().front()) {
    reading = read_as(dialect, loaded.scene, loaded.found);
    options.reading = &reading;
  }
  if (!check_scene_size(loaded.scene, *loaded.sources, options, limits, loaded.found)) return {};
  FlatScene flat = flatten(loaded.scene, *loaded.sources, options);
  if (!check_flat_numbers(flat, loaded.scene, loaded.found)) return {};
  return flat;
}

/// The models of instances with a pose, which are all that is written.
std::set<std::size_t> named_models(const FlatScene& flat) {
  std::set<std::size_t> models;
  for (const FlatInstance& instance : flat.instances) {
    if (instance.model && instance.X_WE) models.insert(*instance.model);
  }
  return models;
}

std::vector<LinkedModel*> models_of(LinkedScene& scene) {
  std::vector<LinkedModel*> models;
  for (LinkedModel& model : scene.models) models.push_back(&model);
  return models;
}

/// The new meshes that a text names.
std::vector<TextFile> named_files(std::vector<TextFile> files, std::string_view text) {
  std::erase_if(files, [&](const TextFile& file) {
    return text.find(escape_xml(file.path)) == std::string_view::npos;
  });
  return files;
}

std::map<const LinkedModel*, NamedPositions> states_of(SrdfsOfRobots&& srdfs) {
  std::map<const LinkedModel*, NamedPositions> states;
  for (auto& [model, srdf] : srdfs) states.emplace(model, std::move(srdf.states));
  return states;
}

/// Fills the text and what belongs to it, without the shapes that collisions get. Findings are
/// added to those of loading.
void write(Session& session, LoadedScene& loaded, const SceneRequest& request,
           const ReplacedCollisions& replaced, SceneResult& result) {
  const FileReader& files = replaced.files();
  const Limits& limits = session.limits();
  const SceneFormat& format = request.format;
  const bool is_expanded = request.form == SceneForm::expand;
  const FlattenOptions flattening{.links = request.links,
                                  .repeats_models = format.repeats_models && is_expanded,
                                  .repeated_parts = is_expanded ? format.repeated_parts : nullptr,
                                  .output_folder = request.output_folder,
                                  .current_folder = request.current_folder.empty()
                                                        ? folder_of_process()
                                                        : request.current_folder,
                                  .old_scenes = &loaded.old_scenes};
  std::optional<FlatScene> flat = flat_scene(loaded, request.dialect, flattening, limits);
  if (!flat) return;
  if (request.base || format.fixes_world_roots) {
    anchor_bases(*flat, loaded.scene, request.base.value_or(BaseChoice::world_roots_fixed));
  }
  if (!request.assets.empty()) {
    // New meshes are written where the result names them.
    result.copies = redirect_assets(*flat, request.assets, flattening, session.files(), limits,
                                    [&](const std::string& file) {
                                      return !request.collisions.folder.empty() &&
                                             file.starts_with(request.collisions.folder + "/");
                                    });
  }
  if (format.reader != nullptr && !is_expanded) {
    judge_models(request, loaded.scene, named_models(*flat), files, limits, *flat, result);
    if (result.refusal) return;
    report_collisions(result.collisions, loaded.found);
  }
  OwnCompanions companions(session, loaded);
  OwnContacts contacts;
  SrdfsOfRobots srdfs;
  if (format.has_contacts || format.loses_link_pairs) {
    for (const LinkedModel& model : loaded.scene.models) {
      if (!model.robot || model.tree.roots.empty()) continue;
      srdfs.emplace(&model, robot_srdf(model, request.srdf, companions));
    }
    contacts = own_contacts(request, loaded.scene, *flat, srdfs, loaded.found);
  }
  MotorOptions motors = request.motors;
  if (format.has_motors) {
    result.refusal = add_controllers(loaded, request, companions, motors);
    if (result.refusal) return;
  }
  KeptMasses masses = replaced.masses();
  for (const LinkedModel& model : loaded.scene.models) keep_meant_tensors(model, masses);
  const SceneExport written{.flat = *flat,
                            .scene = loaded.scene,
                            .sources = *loaded.sources,
                            .losses = loaded.found,
                            .links = request.links,
                            .form = request.form,
                            .ground = request.ground,
                            .motors = std::move(motors),
                            .contacts = std::move(contacts),
                            .group_states = states_of(std::move(srdfs)),
                            .kept_masses = &masses,
                            .names_copies = !request.assets.empty(),
                            .meshes = mesh_source(flattening, result.copies, files, limits),
                            .most_bytes = limits.scene_bytes};
  if (request.ground) stand_on_floor(*flat, written);
  result.text = format.write(written);
  result.copies = named_copies(result.copies, result.text, flattening);
  if (result.text.size() > limits.scene_bytes) {
    const Span place{loaded.scene.scenes.front().source, 0, 0};
    loaded.found
        .report(rules::sml5022_too_many_instances, place,
                "the result has more than " + std::to_string(limits.scene_bytes) + " bytes")
        .help(raise_limit("scene-bytes"));
    result.text.clear();
    return;
  }
  result.has_falling_robots = format.has_ground && !request.ground && has_falling_robots(*flat);
}

/// The same with the shapes of request.collisions. A format that names models gets copies of them,
/// which have these shapes.
void write_with_collisions(Session& session, LoadedScene& loaded, const SceneRequest& request,
                           SceneResult& result) {
  const CollisionOutput output{.output_folder = request.output_folder,
                               .current_folder = request.current_folder.empty()
                                                     ? folder_of_process()
                                                     : request.current_folder,
                               .makes_names = request.format.name == "urdf",
                               .names_meshes = !request.format.has_meshes_inside};
  ReplacedCollisions replaced(session, loaded, request.collisions, output);
  const std::vector<LinkedModel*> models = models_of(loaded.scene);
  if (request.form == SceneForm::expand) {
    result.refusal = replaced.apply(models);
  } else if (const std::string problem = unknown_links(
                 request.collisions, std::vector<const LinkedModel*>(models.begin(), models.end()));
             !problem.empty()) {
    result.refusal = {problem, Refusal::Cause::options};
  }
  if (result.refusal) return;
  write(session, loaded, request, replaced, result);
  if (request.form != SceneForm::expand) return;
  if (!request.format.has_meshes_inside)
    result.new_meshes = named_files(replaced.take_meshes(), result.text);
  result.collisions = replaced.take_collisions();
  replaced.restore();
}

/// Calls `convert` if all poses are known. Its findings are in the report, but are not kept as
/// findings of the scene; `losses` are those about what the result lacks.
template <class Convert>
SceneCheck convert_checked(Session& session, LoadedScene& loaded, bool force,
                           const Convert& convert, std::vector<Diagnostic>* losses = nullptr) {
  DiagnosticSink before = loaded.found;
  std::string late;
  if (first_loss(loaded, force).empty()) {
    const std::uint64_t seconds = max_seconds_of(loaded);
    run_in_time(seconds, convert, [&] {
      late = "that takes more than " + std::to_string(seconds) +
             " s of processor time; allow more with `--max-seconds N`";
    });
  }
  const std::string loss = late.empty() ? first_loss(loaded, force) : late;
  const bool is_forcible =
      !loss.empty() && late.empty() && !force && first_loss(loaded, true).empty();
  SceneCheck check{session.check(loaded), {}};
  if (losses != nullptr) {
    const auto& found = loaded.found.diagnostics();
    std::copy_if(found.begin(), found.end(), std::back_inserter(*losses), is_loss);
    *losses = session.settle(loaded, std::move(*losses));
  }
  loaded.found = std::move(before);
  check.refusal = refusal_for(check.report.diagnostics, force, [&](const Diagnostic& finding) {
    return loss_in_scene(finding, loaded.scene, *loaded.sources);
  });
  if (!loss.empty()) {
    check.refusal = {"cannot be converted: " + loss, Refusal::Cause::findings, is_forcible};
  }
  return check;
}

}  // namespace

SceneCheck check_scene(Session& session, LoadedScene& loaded, bool force) {
  return convert_checked(session, loaded, force, [] {});
}

FlatResult convert_to_flat(Session& session, LoadedScene& loaded, const Dialect& dialect,
                           const FlattenOptions& options, bool force) {
  FlatResult result;
  SceneCheck check = convert_checked(session, loaded, force, [&] {
    auto flat = flat_scene(loaded, dialect, options, session.limits());
    if (flat) result.flat = std::move(*flat);
  });
  result.report = std::move(check.report);
  result.refusal = std::move(check.refusal);
  return result;
}

SceneResult convert_scene(Session& session, LoadedScene& loaded, const SceneRequest& request) {
  SceneResult result;
  SceneCheck check = convert_checked(
      session, loaded, request.force,
      [&] { write_with_collisions(session, loaded, request, result); }, &result.losses);
  result.report = std::move(check.report);
  if (check.refusal) {
    result.refusal = std::move(check.refusal);
  } else if (names_made_models(loaded.scene, request) &&
             !(result.refusal && result.refusal.cause == Refusal::Cause::options)) {
    result.text.clear();
    result.refusal = {"is a world, whose models are in no files of their own, and the result would "
                      "name files; choose a format that contains its models, such as sdf or urdf",
                      Refusal::Cause::options};
  }
  if (!result.refusal && !request.force && lacks_entities(loaded.scene)) {
    result.refusal = {"has no `entities`", Refusal::Cause::findings, true};
  }
  return result;
}

bool is_loss(const Diagnostic& finding) {
  return finding.rule->reported_by == Tool::converters &&
         finding.rule != &rules::sml8212_chosen_value &&
         finding.rule != &rules::sml8213_replaced_collision;
}

SceneForm usual_form(const SceneFormat& format) {
  return format.has_expanded_form ? SceneForm::expand : SceneForm::reference;
}

bool has_form(const SceneFormat& format, SceneForm form) {
  return form == SceneForm::expand ? format.has_expanded_form : format.has_reference_form;
}

}  // namespace smurf
