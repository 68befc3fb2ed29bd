// SPDX-License-Identifier: BSD-3-Clause
// Collects the things of a scene: entities, also of nested scenes, lights and the world.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "ast/scene_keys.hpp"
#include "ast/sections.hpp"
#include "base/files/path.hpp"
#include "diff/collect.hpp"

namespace smurf {
namespace {

bool is_of_world(std::string_view key) {
  return key != "smurfs" && key != "entities" && key != "smurfa" && key != "lights";
}

/// Excludes the keys of the pose, which is compared as a whole, and the file of a nested scene.
bool is_of_entity(std::string_view key) {
  return key != "name" && key != "position" && key != "rotation" && key != "file";
}

std::vector<const KeySpec*> rows_of(std::span<const KeySpec> table) {
  std::vector<const KeySpec*> rows;
  for (const KeySpec& row : table) rows.push_back(&row);
  return rows;
}

class SceneCollector {
 public:
  SceneCollector(const LinkedScene& scene, const SourceMap& sources, YamlProperties& properties,
                 Things& things)
      : scene_(scene), sources_(sources), properties_(properties), things_(things) {
    for (const Instance& instance : scene.instances) {
      instances_.try_emplace({to_size(scene.use(instance).scene), instance.entity}, &instance);
    }
    for (const SceneUse& use : scene.uses) {
      if (!use.outer) continue;
      included_.emplace(to_size(scene.uses[to_size(*use.outer)].scene), use.including_entity);
    }
  }

  void run() {
    for (const SceneUse& use : scene_.uses) {
      const std::size_t scene = to_size(use.scene);
      if (!scenes_.contains(scene)) add_scene(use);
      if (!use.outer) continue;
      const std::size_t outer = to_size(scene_.uses[to_size(*use.outer)].scene);
      const auto entity = entities_.find({outer, use.including_entity});
      if (entity != entities_.end()) things_.all[entity->second].brings = scenes_.at(scene);
    }
  }

 private:
  using EntityKey = std::pair<std::size_t, std::size_t>;  ///< scene file and entity

  Thing& add(std::string_view kind, std::size_t parent, Span place) {
    Thing& thing = things_.all.emplace_back();
    thing.kind = kind;
    thing.parent = parent;
    thing.place = place;
    return thing;
  }

  void add_scene(const SceneUse& use) {
    const SceneFile& file = scene_.file(use);
    const std::size_t index = things_.all.size();
    scenes_.emplace(to_size(use.scene), index);
    Thing& world = add("scene", kNone, {file.source, 0, 0});
    world.is_scene = true;
    world.properties = group_property({}, world.place);
    const bool is_read =
        file.document && file.document->view() && file.document->view().is_mapping();
    if (is_read) {
      world.properties =
          properties_.mapping({}, file.document->view(), rows_of(scene_keys()), is_of_world);
    }
    for (std::size_t i = 0; i < file.scene.entities.size(); ++i) add_entity(use, i, index);
    if (!is_read) return;
    const std::vector<const KeySpec*> rows = sections::lights.keys();
    for (const Light& light : file.scene.lights) {
      Thing& thing = add("light", index, light.name ? light.name.span : light.span);
      thing.name = light.name.value_or("");
      thing.properties = properties_.mapping({}, {*file.document, light.node}, rows,
                                             [](std::string_view key) { return key != "name"; });
    }
  }

  void add_entity(const SceneUse& use, std::size_t index, std::size_t parent) {
    const SceneFile& file = scene_.file(use);
    const Entity& entity = file.scene.entities[index];
    entities_.emplace(EntityKey{to_size(use.scene), index}, things_.all.size());
    Thing& thing = add("entity", parent, place_of(entity));
    thing.name = entity.name.value_or("");
    thing.names = NameKind::entity;
    thing.path = use.path.empty() ? thing.name : use.path + "/" + thing.name;
    thing.properties = group_property({}, entity.span);
    if (file.document && entity.node != yaml::kNoNode) {
      thing.properties = properties_.mapping({}, {*file.document, entity.node},
                                             rows_of(all_entity_keys()), is_of_entity);
    }
    for (Property& property : thing.properties.members) {
      // The default is the extension of the file.
      if (property.key != "type" || !entity.file) continue;
      property.is_default = "." + property.text == path::to_lower(path::extension(*entity.file));
    }
    const Span place = entity.position.written ? entity.position.span : entity.rotation.span;
    const Pose X_PE{entity.position.value_or({}), to_quaternion(entity.rotation)};
    add_member(thing.properties,
               pose_property("placement", X_PE, place.empty() ? thing.place : place));
    add_file(thing, entity, EntityKey{to_size(use.scene), index});
  }

  /// Models are compared separately. A file that nothing else reads is compared byte by byte.
  void add_file(Thing& thing, const Entity& entity, EntityKey key) {
    if (!entity.file || included_.contains(key)) return;
    Property file = text_property("file", *entity.file, entity.file.span);
    const auto instance = instances_.find(key);
    const bool is_known = instance != instances_.end();
    const DataFile* data = is_known ? data_of(*instance->second) : nullptr;
    if (data != nullptr && data->document.view()) {
      if (!std::exchange(told_[data], true)) {
        add_member(thing.properties, properties_.value("contents", data->document.view(), nullptr));
      }
    } else if (is_known && !instance->second->model && !instance->second->file.empty()) {
      file.form = Property::Form::file;
      file.path = instance->second->file;
    }
    add_member(thing.properties, std::move(file));
  }

  const DataFile* data_of(const Instance& instance) {
    if (data_.empty()) {
      for (const DataFile& file : scene_.data_files)
        data_.emplace(sources_.path(file.source), &file);
    }
    const auto found = data_.find(instance.file);
    return found == data_.end() ? nullptr : found->second;
  }

  const LinkedScene& scene_;
  const SourceMap& sources_;
  YamlProperties& properties_;
  Things& things_;
  std::map<EntityKey, const Instance*> instances_;  ///< the first one of each entity
  std::map<std::size_t, std::size_t> scenes_;       ///< things, by scene file
  std::map<EntityKey, std::size_t> entities_;       ///< things
  std::set<EntityKey> included_;                    ///< entities that include a scene
  std::map<std::string, const DataFile*> data_;     ///< by path
  std::map<const DataFile*, bool> told_;
};

}  // namespace

Things collect(const LinkedScene& scene, const SourceMap& sources, YamlProperties& properties) {
  Things things;
  SceneCollector(scene, sources, properties, things).run();
  things.references = references_of(scene);
  sort_by_place(things.references);
  return things;
}

}  // namespace smurf
