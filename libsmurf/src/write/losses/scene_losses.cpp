// SPDX-License-Identifier: BSD-3-Clause
#include "write/losses/scene_losses.hpp"

#include <algorithm>
#include <set>

#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "smurf/archive_files.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf {
namespace {

/// NAME of package://NAME/REST; none for other paths.
std::optional<std::string_view> package_in(std::string_view filename) {
  constexpr std::string_view kScheme = "package://";
  if (!filename.starts_with(kScheme)) return std::nullopt;
  filename.remove_prefix(kScheme.size());
  return filename.substr(0, filename.find('/'));
}

const std::string& name_in(const std::string& name) { return name; }
const std::string& name_in(const FoundThing& thing) { return thing.name; }

/// "`a`, `b` and 3 more". Two models may have the same names, which are listed once.
template <class Names>
std::string list(const Names& names) {
  constexpr std::size_t kListed = 8;
  std::set<std::string_view> known;
  std::vector<std::string> all;
  for (const auto& each : names) {
    const std::string& name = name_in(each);
    if (!name.empty() && !known.insert(name).second) continue;
    all.push_back(name.empty() ? "a node without name" : quoted(name));
  }
  return shortlist(all, kListed);
}

}  // namespace

std::string SceneLosses::path(std::size_t instance) const {
  return quoted(scene_.flat.instances[instance].path);
}

Span SceneLosses::place(std::size_t instance) const {
  return place_of(*scene_.flat.instances[instance].entity);
}

void SceneLosses::entity(std::size_t instance, std::string_view why) {
  scene_.losses.report(rules::sml8201_lost_entity, place(instance),
                       path(instance) + " is not in the " + format_ + ": " + std::string(why));
}

void SceneLosses::joint_pose(std::size_t instance, std::string_view why) {
  if (scene_.flat.instances[instance].joint_positions.empty()) return;
  const Field<std::string>& pose = scene_.flat.instances[instance].entity->pose;
  scene_.losses.report(rules::sml8202_lost_joint_pose, pose.written ? pose.span : place(instance),
                       path(instance) + " starts with its joints at zero in the " + format_ + ": " +
                           std::string(why));
}

void SceneLosses::anchor(std::size_t instance, std::string_view why) {
  const Field<std::string>& anchor = scene_.flat.instances[instance].entity->anchor;
  scene_.losses.report(rules::sml8203_lost_anchor, anchor.written ? anchor.span : place(instance),
                       "the anchor of " + path(instance) + " is not in the " + format_ + ": " +
                           std::string(why));
}

void SceneLosses::shape(Span span, std::string_view what) {
  scene_.losses.report(rules::sml8205_lost_shape, span,
                       std::string(what) + " is not in the " + format_);
}

void SceneLosses::unseen_shape(Span span, const FlatGeometry& geometry, std::string_view reason) {
  // All shapes of an old scene have the place of its entity.
  const auto* mesh = std::get_if<FlatMesh>(&geometry);
  const std::string file = mesh != nullptr ? mesh->file : std::string();
  if (!unseen_.insert({to_size(span.source), span.begin, file}).second) return;
  if (mesh == nullptr) return shape(span, "the heightmap");
  Diagnostic& loss = scene_.losses.report(rules::sml8205_lost_shape, span,
                                          "the mesh " + quoted(mesh->file) + " is not in the " +
                                              format_ + ": " + why_unseen(mesh->file, reason));
  if (package_in(mesh->file) == std::string_view()) {
    loss.help("write the path from the folder of the URDF, or `package://NAME/PATH`");
  } else if (const std::string_view package = lost_package(mesh->file); !package.empty()) {
    loss.when(cases::kLostPackage);
    loss.help("name its folder: `--package " + std::string(package) + "=DIR`");
  }
}

std::string_view SceneLosses::lost_package(std::string_view file) const {
  const std::optional<std::string_view> package = package_in(file);
  return package && !has_found(*package) ? *package : std::string_view();
}

/// Whether a model names a file of the package that is there.
bool SceneLosses::has_found(std::string_view package) const {
  for (const LinkedModel& model : scene_.scene.models) {
    for (const MeshReference& mesh : model.meshes) {
      if (mesh.exists && package_in(mesh.filename) == package) return true;
    }
  }
  return false;
}

/// An address that leads to no file keeps its scheme, and was not looked for in any folder.
std::string SceneLosses::why_unseen(const std::string& file, std::string_view reason) const {
  if (const std::optional<std::string_view> package = package_in(file)) {
    if (package->empty()) return "the address names no package";
    if (has_found(*package)) return "there is no such file in the package " + quoted(*package);
    return "no folder of the package " + quoted(*package) + " was found";
  }
  const std::size_t scheme = file.find("://");
  if (scheme != std::string::npos && !file.starts_with("file:")) {
    return "addresses of the scheme " + quoted(file.substr(0, scheme)) + " are not read";
  }
  return "the file " + std::string(reason);
}

void SceneLosses::joint(const urdf::Joint& joint, std::string_view written_as) {
  scene_.losses.report(rules::sml8206_simplified_joint,
                       joint.type_name.written ? joint.type_name.span : joint.span,
                       "the joint " + quoted(joint.name.value_or({})) + " is " +
                           std::string(written_as) + " in the " + format_);
}

Vector3 SceneLosses::axis_of(const urdf::Joint& joint) {
  const std::optional<Vector3> axis = joint_axis(joint);
  if (!axis && without_axis_.insert(&joint).second) {
    this->joint(joint, "about or along x, since the axis is zero,");
  }
  return axis.value_or(Vector3{1, 0, 0});
}

void SceneLosses::table() {
  for (const LinkedModel& model : scene_.scene.models) of_model(model);
  for (const SceneThing& thing : scene_things()) {
    if (thing.of == ThingOf::scene || thing.in_scene != nullptr) of_scene(thing);
    const auto noted = noted_.find(thing.title);
    if (noted == noted_.end()) continue;
    std::vector<FoundThing> found;
    for (auto& [place, each] : noted->second) found.push_back(each);
    report(thing, found);
  }
  unknown_entities();
  old_scenes();
}

/// A model that the result names by file name keeps the contents of that file.
bool SceneLosses::is_referred_to(const LinkedModel& model) const {
  if (column_ == SceneColumn::dmd) return true;
  if (scene_.form != SceneForm::reference) return false;
  if (column_ != SceneColumn::sdf || !model.robot || model.tree.roots.empty()) return true;
  return inertial_of(model.link(model.tree.roots.front())).has_value();
}

void SceneLosses::of_model(const LinkedModel& model) {
  if (model.files.empty()) return;
  std::string annotations, settings, shown;
  std::optional<Span> first;
  const auto add = [](std::string& text, const std::string& more) {
    text += (text.empty() ? "" : ", ") + more;
  };
  // Readers of the URDF do not see annotations; this also applies to Drake's directives.
  const bool is_named = is_referred_to(model);
  const SceneColumn column = is_named ? SceneColumn::dmd : column_;
  for (const SceneThing& thing : scene_things()) {
    const Fate fate = thing.cells[to_size(column)].fate;
    const bool is_searched = thing.in_model != nullptr || thing.in_motors != nullptr;
    if (fate == Fate::kept || !is_searched) continue;
    if (thing.of == ThingOf::urdf && is_named && column_ != SceneColumn::dmd) continue;
    const std::vector<FoundThing> found = thing.in_model != nullptr
                                              ? thing.in_model(model, column)
                                              : thing.in_motors(model, column, scene_.motors);
    if (found.empty()) continue;
    if (thing.of == ThingOf::annotation || thing.of == ThingOf::setting) {
      add(thing.of == ThingOf::setting ? settings : annotations,
          counted(found.size(), thing.title));
    } else if (fate == Fate::shown) {
      add(shown, std::string(thing.title));
      if (!first) first = found.front().span;
    } else {
      report(thing, found);
    }
  }
  // Whole things first: they are missed before the settings of others.
  const std::string& missed = annotations.empty() ? settings : annotations;
  if (!missed.empty()) {
    Diagnostic& lost = scene_.losses.report(
        rules::sml8207_lost_annotations, {model.files.front().source, 0, 0},
        "the annotations of " + quoted(model.path) + " are not in the " + format_ + ": " + missed);
    if (!annotations.empty() && !settings.empty()) lost.note("also lost: " + settings);
  }
  if (!shown.empty()) {
    scene_.losses
        .report(rules::sml8207_lost_annotations, *first,
                "the " + format_ + " shows " + quoted(model.path) + " and does not have: " + shown)
        .when(cases::kPicture);
  }
}

void SceneLosses::report(const SceneThing& thing, const std::vector<FoundThing>& found) {
  if (found.empty()) return;
  const Cell& cell = thing.cells[to_size(column_)];
  const std::string what = std::string(thing.title) + " (" + list(found) + ")";
  // The text of a cell `partly` says what is kept, and not why the rest is lost.
  const bool has_reason = !cell.reason.empty() && cell.fate != Fate::partly;
  const std::string reason = has_reason ? ": " + std::string(cell.reason) : "";
  const Span span = found.front().span;
  switch (cell.fate) {
  case Fate::added:
    scene_.losses.report(rules::sml8212_chosen_value, span,
                         what + ": the " + format_ + " has " + std::string(cell.reason));
    return;
  case Fate::changed:
    scene_.losses.report(rules::sml8211_lost_part, span,
                         what + " are something else in the " + format_ + reason);
    return;
  default:
    scene_.losses.report(rules::sml8211_lost_part, span,
                         what + " are not in the " + format_ + reason);
    return;
  }
}

/// Keys of entities of types that no format knows.
void SceneLosses::unknown_entities() {
  for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
    const FlatInstance& instance = scene_.flat.instances[i];
    if (instance.properties.empty() || !instance.shapes.empty() || instance.model) continue;
    std::string keys;
    for (const ValueMember& member : instance.properties) {
      keys += (keys.empty() ? "" : ", ") + quoted(member.key);
    }
    scene_.losses.report(rules::sml8207_lost_annotations, place(i),
                         "keys of " + path(i) + " are not in the " + format_ + ": " + keys);
  }
}

void SceneLosses::of_scene(const SceneThing& thing) {
  const Fate fate = thing.cells[to_size(column_)].fate;
  if (fate == Fate::kept || fate == Fate::shown) return;
  if (thing.in_scene != nullptr) report(thing, thing.in_scene(scene_, column_));
  for (const SceneFile& file : scene_.scene.scenes) report_setting(thing.setting, file);
  if (thing.setting == WorldSetting::lights) lights_of_old_scenes();
}

void SceneLosses::lights_of_old_scenes() {
  for (const FlatOldScene& old : scene_.flat.old_scenes) {
    if (old.lamps.empty()) continue;
    scene_.losses.report(rules::sml8204_lost_world_setting, place(old.instance),
                         counted(old.lamps.size(), "light") + " of " + path(old.instance) +
                             (old.lamps.size() == 1 ? " is" : " are") + " not in the " + format_);
  }
}

std::vector<std::string> SceneLosses::archived_files(std::size_t index) const {
  const FlatInstance& instance = scene_.flat.instances[index];
  std::vector<std::string> files;
  const auto add = [&](const std::string& file) {
    if (is_in_archive(file)) files.push_back(file);
  };
  if (instance.model) {
    const FlatModel& model = scene_.flat.models[*instance.model];
    if (scene_.form == SceneForm::reference) {
      add(model.urdf);
    } else {
      for (const auto& [written, file] : model.resources) add(file);
      for (const auto& [written, file] : model.annotated_textures) add(file);
    }
  }
  for (const FlatShape& shape : instance.shapes) {
    if (const auto* mesh = std::get_if<FlatMesh>(&shape.geometry)) add(mesh->file);
    if (const auto* map = std::get_if<FlatHeightmap>(&shape.geometry)) add(map->file);
  }
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

void SceneLosses::files_in_archives() {
  std::set<std::size_t> models;
  for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
    const std::optional<std::size_t>& model = scene_.flat.instances[i].model;
    if (model && !models.insert(*model).second) continue;
    const std::vector<std::string> files = archived_files(i);
    if (files.empty()) continue;
    Diagnostic& diagnostic = scene_.losses.report(
        rules::sml8210_file_in_archive, place(i),
        "readers of the " + format_ + " do not look into the archive for " + list(files));
    diagnostic.help(scene_.form == SceneForm::reference ? "unpack it, or use --form expand"
                                                        : "--copy-assets DIR copies the files");
  }
}

void SceneLosses::old_scenes() {
  for (const FlatOldScene& old : scene_.flat.old_scenes) {
    const Span span = place(old.instance);
    if (!old.movable.empty()) {
      scene_.losses.report(rules::sml8209_old_nodes_stand_still, span,
                           "moving parts of " + path(old.instance) + " stand still in the " +
                               format_ + ": " + list(old.movable));
    }
    if (!old.shapeless.empty()) {
      shape(span, "the part of " + path(old.instance) + " whose shape is not known, " +
                      list(old.shapeless) + ",");
    }
    std::string others;
    for (const auto& [what, number] : old.others) {
      others += (others.empty() ? "" : ", ") + counted(number, what);
    }
    if (others.empty()) continue;
    scene_.losses.report(rules::sml8207_lost_annotations, span,
                         "more of " + path(old.instance) + " is not in the " + format_ + ": " +
                             others);
  }
}

void SceneLosses::report_setting(WorldSetting setting, const SceneFile& file) {
  const auto& physics = file.scene.physics;
  const auto report = [&](Span span, std::string_view what) {
    scene_.losses.report(rules::sml8204_lost_world_setting, span,
                         std::string(what) + " not in the " + format_);
  };
  switch (setting) {
  case WorldSetting::none: return;
  case WorldSetting::gravity:
    if (physics && physics->gravity) report(physics->gravity.span, "the gravity is");
    return;
  case WorldSetting::step_size:
    if (physics && physics->step_size) report(physics->step_size.span, "the step size is");
    return;
  case WorldSetting::solver:
    if (physics && physics->cfm) report(physics->cfm.span, "the constraint force mixing is");
    if (physics && physics->erp) report(physics->erp.span, "the error reduction is");
    return;
  case WorldSetting::environment:
    if (file.document && file.scene.environment != yaml::kNoNode) {
      report(yaml::View{*file.document, file.scene.environment}.key_span(), "the environment is");
    }
    return;
  case WorldSetting::plugins:
    if (file.document) {
      const yaml::View plugins = file.document->view().find("plugins");
      if (plugins) report(plugins.key_span(), "the list of plug-ins is");
    }
    return;
  case WorldSetting::lights:
    for (const Light& light : file.scene.lights) {
      report(light.name.written ? light.name.span : light.span, "the light is");
    }
    return;
  }
}

}  // namespace smurf
