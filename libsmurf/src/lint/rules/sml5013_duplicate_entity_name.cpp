// SPDX-License-Identifier: BSD-3-Clause

#include <map>

#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5013_duplicate_entity_name_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for (const SceneFile& file : scene.scenes) {
    std::map<std::string_view, const Entity*> first;
    for (const Entity& entity : file.scene.entities) {
      if (!entity.name || entity.name->empty()) continue;
      if (kind_of(entity_type(entity)) == EntityKind::scene) continue;
      const auto [known, is_new] = first.emplace(*entity.name, &entity);
      if (is_new) continue;
      // In a drawing the name may be that of a file that several groups share.
      const bool is_shared = entity.name.span == known->second->name.span;
      const auto place = [&](const Entity& one) { return is_shared ? one.span : one.name.span; };
      Diagnostic& diagnostic =
          findings.report(place(entity), "the scene already has an entity " + quoted(*entity.name));
      diagnostic.label(place(*known->second), "the first one is here");
      if (!is_shared) continue;
      diagnostic.severity = Severity::warning;
      diagnostic.help("give each group a separate file, or leave `name` out of the file");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "creates both, and every reference refers to the first",
     "MARS EntityManager.cpp:229-239"},
    {&readers::mars2, Effect::changes, "creates one frame for both", "MarsSceneLoader.cpp"},
    {&readers::phobos, Effect::refuses, "stops with an assertion", "Phobos multiple.py"},
};

}  // namespace

extern constinit const Rule sml5013_duplicate_entity_name{
    .id = "SML5013",
    .name = "duplicate-entity-name",
    .severity = Severity::error,
    .summary = "Two entities of one scene have the same name.",
    .remedy = "Rename one of them, and all references to it.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5013_duplicate_entity_name_file
