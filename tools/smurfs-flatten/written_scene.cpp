// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/written_scene.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/limits.hpp"
#include "base/rules.hpp"
#include "common/mesh_source.hpp"
#include "smurf/flatten.hpp"
#include "smurfs-flatten/assets.hpp"
#include "smurfs-flatten/bases.hpp"

namespace smurf::tools {
namespace {

/// Gives the instances of a scene the poses of a dialect for a while. The rules judge a scene in
/// the first dialect, as documented.
class InDialect {
 public:
  InDialect(const Dialect& dialect, LinkedScene& scene, DiagnosticSink& found) : scene_(scene) {
    if (&dialect == dialects().front()) return;
    instances_ = scene.instances;
    joint_poses_ = scene.joint_poses;
    apply_dialect(dialect, scene, found);
  }
  ~InDialect() {
    std::move(instances_.begin(), instances_.end(), scene_.instances.begin());
    if (!joint_poses_.empty()) scene_.joint_poses = std::move(joint_poses_);
  }
  InDialect(const InDialect&) = delete;
  InDialect& operator=(const InDialect&) = delete;

 private:
  LinkedScene& scene_;
  std::vector<Instance> instances_;
  std::vector<JointPositions> joint_poses_;
};

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

}  // namespace

WrittenScene write_scene(LoadedScene& loaded, const SceneWishes& wishes, const FileReader& files,
                         const Limits& limits, DiagnosticSink& found) {
  LinkedScene& scene = loaded.scene;
  const SourceMap& sources = *loaded.sources;
  const SceneFormat& format = wishes.format;
  const bool is_expanded = wishes.form == SceneForm::expand;
  Bases bases(scene);
  if (wishes.base || format.fixes_world_roots) {
    bases.anchor(wishes.base.value_or(BaseChoice::world_roots_fixed));
  }
  const InDialect read_as(wishes.dialect, scene, found);
  const FlattenOptions flattening{.links = wishes.links,
                                  .repeats_models = format.repeats_models && is_expanded,
                                  .repeated_parts = is_expanded ? format.repeated_parts : nullptr,
                                  .output_folder = wishes.output_folder,
                                  .current_folder = wishes.current_folder,
                                  .old_scenes = &loaded.old_scenes};
  if (!check_scene_size(scene, sources, flattening, limits, found)) return {};
  FlatScene flat = flatten(scene, sources, flattening);
  if (!check_flat_numbers(flat, scene, found)) return {};
  WrittenScene result;
  if (!wishes.assets.empty()) {
    result.copies = redirect_assets(flat, wishes.assets, flattening, files, limits);
  }
  const SceneExport written{.flat = flat,
                            .scene = scene,
                            .sources = sources,
                            .losses = found,
                            .links = wishes.links,
                            .form = wishes.form,
                            .ground = wishes.ground,
                            .names_copies = !wishes.assets.empty(),
                            .meshes = mesh_source(flattening, result.copies, files, limits),
                            .most_bytes = limits.scene_bytes};
  if (wishes.ground) bases.stand_on_floor(flat, written);
  result.text = format.write(written);
  result.copies = named_copies(result.copies, result.text, flattening);
  if (result.text.size() > limits.scene_bytes) {
    const Span place{scene.scenes.front().source, 0, 0};
    found
        .report(rules::sml5022_too_many_instances, place,
                "the result has more than " + std::to_string(limits.scene_bytes) + " bytes")
        .help(raise_limit("scene-bytes"));
    return {};
  }
  result.has_falling_robots = format.has_ground && !wishes.ground && has_falling_robots(flat);
  return result;
}

bool is_loss(const Diagnostic& finding) {
  return finding.rule->reported_by == Tool::converters && finding.rule->id != "SML8212";
}

SceneForm usual_form(const SceneFormat& format) {
  return format.has_expanded_form ? SceneForm::expand : SceneForm::reference;
}

bool has_form(const SceneFormat& format, SceneForm form) {
  return form == SceneForm::expand ? format.has_expanded_form : format.has_reference_form;
}

}  // namespace smurf::tools
