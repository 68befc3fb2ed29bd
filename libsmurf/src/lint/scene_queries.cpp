// SPDX-License-Identifier: BSD-3-Clause
#include "lint/scene_queries.hpp"

#include "base/files/path.hpp"
#include "base/text/suggest.hpp"
#include "lint/queries.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf {

void for_each_entity(const LinkedScene& scene,
                     const std::function<void(const SceneFile&, const Entity&)>& visit) {
  for (const SceneFile& file : scene.scenes) {
    if (!file.document) continue;
    for (const Entity& entity : file.scene.entities) visit(file, entity);
  }
}

void for_each_use(const LinkedScene& scene, const std::function<void(const Use&)>& visit) {
  for (const SceneUse& use : scene.uses) {
    if (!use.outer) continue;
    visit({scene, *scene.entity(use), scene.uses[to_size(*use.outer)], use.placement, nullptr});
  }
  for (const Instance& instance : scene.instances) {
    visit({scene, scene.entity(instance), scene.use(instance), instance.placement, &instance});
  }
}

yaml::View mapping_of(const SceneFile& file, const Entity& entity) {
  return {*file.document, entity.node};
}

Span type_place(const Entity& entity) {
  if (entity.type && !entity.type->empty()) return entity.type.span;
  return entity.file && !entity.file->empty() ? entity.file.span : entity.uri.span;
}

yaml::View world_value(const SceneFile& file, std::string_view key) {
  if (!file.document || path::extension(file.path) == ".smurfa") return {};
  const yaml::View root = file.document->view();
  if (!root || !root.is_mapping()) return {};
  const yaml::View value = root.find(key);
  return value && !value.is_null() ? value : yaml::View();
}

bool has_schema(const LinkedScene& scene, std::string_view type) {
  return scene.schemas != nullptr && scene.schemas->has_entity_type(type);
}

const CustomSection* slip_of(const Entity& entity, std::string_view key) {
  const std::string_view known[] = {key};
  for (const CustomSection& extra : entity.extra) {
    if (nearest(extra.name.value, known)) return &extra;
  }
  return nullptr;
}

std::string title(const Entity& entity) {
  const bool is_named = entity.name && !entity.name->empty();
  return is_named ? "entity " + quoted(*entity.name) : "this entity";
}

}  // namespace smurf
