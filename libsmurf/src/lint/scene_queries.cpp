// SPDX-License-Identifier: BSD-3-Clause
#include "lint/scene_queries.hpp"

#include "lint/queries.hpp"

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

std::string title(const Entity& entity) {
  const bool is_named = entity.name && !entity.name->empty();
  return is_named ? "entity " + quoted(*entity.name) : "this entity";
}

}  // namespace smurf
