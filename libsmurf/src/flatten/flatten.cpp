// SPDX-License-Identifier: BSD-3-Clause
// LinkedScene -> FlatScene: linear in the number of instances, links and properties.
#include "smurf/flatten.hpp"

#include <algorithm>
#include <map>

#include "base/deadline.hpp"
#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/text/unique_names.hpp"
#include "flatten/old_shapes.hpp"
#include "flatten/plain_values.hpp"
#include "flatten/scene_shapes.hpp"
#include "link/imported_world.hpp"
#include "link/scene_link.hpp"
#include "smurf/dialect.hpp"

namespace smurf {
namespace {

class Flattener {
 public:
  Flattener(const LinkedScene& scene, const SourceMap& sources, const FlattenOptions& options)
      : scene_(scene), sources_(sources), options_(options) {}

  FlatScene run() {
    flat_.scene = relative(scene_.path);
    for (std::size_t i = 0; i < scene_.models.size(); ++i) add_model(i);
    set_world();
    flat_.joint_poses = options_.reading ? options_.reading->joint_poses : scene_.joint_poses;
    flat_.instances.reserve(scene_.instances.size());
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
      Deadline::look(16);
      flat_.instances.push_back(flat_instance(i));
    }
    return std::move(flat_);
  }

 private:
  /// Both paths are made absolute, so that ".." and mixed kinds of paths work.
  std::string relative(const std::string& path) {
    const auto [known, is_new] = relative_.try_emplace(path);
    if (is_new && !path.empty()) {
      known->second =
          path::relative(places::absolute_from(options_.current_folder, path),
                         places::absolute_from(options_.current_folder, options_.output_folder));
    }
    return known->second;
  }

  void add_model(std::size_t index) {
    const LinkedModel& model = scene_.models[index];
    std::string stem(name_in_world(model.path));
    if (stem.empty()) stem = path::stem(model.path);
    if (stem.empty()) stem = "model";
    FlatModel flat{ids_.add(stem),
                   model.has_main ? "smurf" : "urdf",
                   relative(model.path),
                   relative(model.urdf_path),
                   ModelIndex{static_cast<std::uint32_t>(index)},
                   {},
                   {}};
    for (const MeshReference& mesh : model.meshes) {
      if (!mesh.path.empty()) flat.resources.emplace(mesh.filename, relative(mesh.path));
    }
    for (const MaterialAnnotation& material : model.annotations.materials) {
      if (!material.diffuse_texture || material.diffuse_texture->empty()) continue;
      const std::string file = path::join(path::parent(model.path), *material.diffuse_texture);
      flat.annotated_textures.emplace(*material.diffuse_texture, relative(file));
    }
    flat_.models.push_back(std::move(flat));
  }

  /// The settings of the loaded scene override those of included scenes; of these, the last one
  /// applies. An included .smurfa has no world settings.
  void set_world() {
    for (std::size_t i = scene_.uses.size(); i-- > 0;) {
      const SceneFile& file = scene_.file(scene_.uses[i]);
      const bool is_assembly = path::extension(file.path) == ".smurfa";
      if (!file.document || (i > 0 && is_assembly)) continue;
      const bool is_last_word = i == 0;
      if (file.scene.physics) set_physics(*file.scene.physics, is_last_word);
      if (file.scene.environment != yaml::kNoNode && (is_last_word || flat_.environment.empty())) {
        flat_.environment = to_object({*file.document, file.scene.environment});
      }
    }
    for (const SceneUse& use : scene_.uses) {
      const SceneFile& file = scene_.file(use);
      if (use.outer && path::extension(file.path) == ".smurfa") continue;
      for (const Light& light : file.scene.lights) {
        flat_.lights.push_back(to_value({*file.document, light.node}));
      }
    }
  }

  template <class T>
  static void set(std::optional<T>& value, const Field<T>& field, bool is_last_word) {
    if (field && (is_last_word || !value)) value = *field;
  }

  void set_physics(const Physics& physics, bool is_last_word) {
    set(flat_.physics.gravity, physics.gravity, is_last_word);
    set(flat_.physics.cfm, physics.cfm, is_last_word);
    set(flat_.physics.erp, physics.erp, is_last_word);
    Field<double> seconds = physics.step_size;
    if (seconds) *seconds /= 1000;
    set(flat_.physics.step_size, seconds, is_last_word);
  }

  FlatAttachment flat_attachment(const Attachment& attachment) const {
    if (attachment.kind != Attachment::Kind::link) return {attachment.kind, {}, {}, 0};
    return {attachment.kind, scene_.instance(attachment.instance).path, attachment.link,
            to_size(attachment.instance)};
  }

  /// Where the scene, or the dialect, places an instance.
  void place(const Instance& instance, std::size_t index, FlatInstance& flat) const {
    if (options_.reading == nullptr) {
      flat.X_WE = instance.X_WE;
      flat.anchor = flat_attachment(instance.placement.anchor);
      flat.parent = flat_attachment(instance.placement.parent);
      flat.joint_pose = instance.joint_pose;
      return;
    }
    const EntityReading& reading = options_.reading->entities[index];
    flat.X_WE = reading.X_WE;
    flat.anchor = flat_attachment(reading.anchor);
    flat.parent = flat_attachment(reading.parent);
    flat.joint_pose = reading.joint_pose;
  }

  FlatInstance flat_instance(std::size_t index) {
    const Instance& instance = scene_.instances[index];
    const Entity& entity = scene_.entity(instance);
    const SceneFile& file = scene_.file(scene_.use(instance));
    FlatInstance flat;
    flat.entity = &entity;
    flat.name = instance.name;
    flat.path = instance.path;
    flat.type = instance.type;
    if (instance.model) {
      flat.model = to_size(*instance.model);
    } else {
      flat.file = relative(instance.file);
    }
    flat.source_file = relative(file.path);
    flat.source_line = sources_.line_of(entity.span.source, entity.span.begin);
    place(instance, index, flat);
    flat.properties = properties(instance, entity, file);
    if (!instance.model) flat.shapes = shapes_of(flat, entity.position.written);
    if (is_old_scene(instance.type)) add_old_scene(instance, flat);
    if (const LinkedModel* model = scene_.model(instance)) {
      add_joints(*model, flat);
      if (options_.links) add_links(*model, flat);
    }
    return flat;
  }

  /// The keys that are in no other member of an instance, including `pose` and `root` of unknown
  /// types, whose meaning is unknown.
  static Value::Object properties(const Instance& instance, const Entity& entity,
                                  const SceneFile& file) {
    Value::Object kept;
    if (instance.model) {
      for (const CustomSection& key : entity.extra) {
        kept.push_back({key.name.value, to_value({*file.document, key.node})});
      }
      return kept;
    }
    constexpr std::string_view kShown[] = {"name",     "file",   "type",  "position",
                                           "rotation", "parent", "anchor"};
    kept = to_object({*file.document, entity.node});
    std::erase_if(kept, [&](const ValueMember& member) {
      return std::find(std::begin(kShown), std::end(kShown), member.key) != std::end(kShown);
    });
    return kept;
  }

  void add_old_scene(const Instance& instance, FlatInstance& flat) {
    if (options_.old_scenes == nullptr) return;
    const auto file = options_.old_scenes->find(instance.file);
    if (file == options_.old_scenes->end()) return;
    const OldSceneContent& content = old_content(file->second, instance);
    flat.shapes = content.shapes;
    FlatOldScene& rest = flat_.old_scenes.emplace_back(content.rest);
    rest.instance = flat_.instances.size();
    const Span place = place_of(scene_.entity(instance));
    for (Light& lamp : rest.lamps) lamp.span = lamp.name.span = place;
  }

  /// Read once: it is the same for all entities with a name, and for all without one.
  const OldSceneContent& old_content(const OldSceneFile& file, const Instance& instance) {
    const auto [known, is_new] = old_contents_.try_emplace({&file, instance.name.empty()});
    if (!is_new) return known->second;
    known->second = old_scene_content(file, instance);
    for (FlatShape& shape : known->second.shapes) {
      if (auto* mesh = std::get_if<FlatMesh>(&shape.geometry)) mesh->file = relative(mesh->file);
    }
    return known->second;
  }

  void add_joints(const LinkedModel& model, FlatInstance& flat) {
    const auto [known, is_new] = positions_.try_emplace({*flat.model, flat.joint_pose});
    if (is_new) known->second = joints_of(model, flat_.joint_poses[to_size(flat.joint_pose)]);
    flat.joint_positions = known->second;
  }

  static std::vector<std::pair<std::string, double>> joints_of(const LinkedModel& model,
                                                               const JointPositions& given) {
    std::vector<std::pair<std::uint32_t, double>> by_joint;
    for (const auto& [name, position] : given) {
      if (const auto joint = model.joint_names.find(name)) by_joint.emplace_back(*joint, position);
    }
    std::sort(by_joint.begin(), by_joint.end());
    std::vector<std::pair<std::string, double>> positions;
    for (const auto& [joint, position] : by_joint) {
      positions.emplace_back(*model.robot->joints[joint].name, position);
    }
    return positions;
  }

  void add_links(const LinkedModel& model, FlatInstance& flat) {
    if (!flat.X_WE) return;
    const std::vector<std::optional<Pose>>& frames =
        frames_.of(scene_, ModelIndex{static_cast<std::uint32_t>(*flat.model)}, flat.joint_pose,
                   flat_.joint_poses);
    for (std::size_t i = 0; i < frames.size(); ++i) {
      const Field<std::string>& name = model.robot->links[i].name;
      if (!frames[i] || !name || model.link_names.find(*name) != i) continue;
      flat.links.emplace_back(*name, *flat.X_WE * *frames[i]);
    }
  }

  const LinkedScene& scene_;
  const SourceMap& sources_;
  const FlattenOptions& options_;
  FlatScene flat_;
  std::map<std::string, std::string> relative_;
  UniqueNames ids_;
  std::map<std::pair<std::size_t, JointPoseIndex>, std::vector<std::pair<std::string, double>>>
      positions_;
  std::map<std::pair<const OldSceneFile*, bool>, OldSceneContent> old_contents_;
  LinkFrames frames_;
};

}  // namespace

FlatScene flatten(const LinkedScene& scene, const SourceMap& sources,
                  const FlattenOptions& options) {
  return Flattener(scene, sources, options).run();
}

std::optional<InstanceIndex> find_instance(const LinkedScene& scene, std::string_view name) {
  std::optional<InstanceIndex> by_name;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const InstanceIndex index{static_cast<std::uint32_t>(i)};
    if (scene.instances[i].path == name) return index;
    if (!by_name && scene.instances[i].name == name) by_name = index;
  }
  return by_name;
}

}  // namespace smurf
