// SPDX-License-Identifier: BSD-3-Clause
#include <unordered_map>

#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    std::unordered_map<std::string_view, const Entity*> first;
    for (const Entity& entity : file.scene.entities) {
      if (!entity.name || entity.name->empty()) continue;
      if (kind_of(entity_type(entity)) == EntityKind::scene) continue;
      const auto [known, is_new] = first.emplace(*entity.name, &entity);
      if (is_new) continue;
      Diagnostic& diagnostic = findings.report(
          entity.name.span, "the scene already has an entity " + quoted(*entity.name));
      diagnostic.labels.push_back({known->second->name.span, "the first one is here"});
    }
  }
}

}  // namespace

extern constinit const Rule sml5013_duplicate_entity_name{
    .id = "SML5013",
    .name = "duplicate-entity-name",
    .severity = Severity::error,
    .summary = "Two entities of one scene have the same name.",
    .why = "MARS creates both and every reference means the first; MARS 2 has one frame for the "
           "two, and Phobos stops with an assertion.",
    .remedy = "Rename one of them, and what refers to it.",
    .sources = "MARS EntityManager.cpp:229-239; Phobos multiple.py; MarsSceneLoader.cpp.",
    .check_scene = check};

}  // namespace smurf::rules
