// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5012_unnamed_entity_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (entity.name ? !entity.name->empty() : entity.name.written) return;
    // An include is not an entity; its name is never used.
    if (kind_of(entity_type(entity)) == EntityKind::scene) return;
    if (!entity.name.written && slip_of(entity, "name") != nullptr) return;  // misspelt-scene-key
    findings.report(place_of(entity), "this entity has no name");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "creates unnamed entities that have a parent in another order",
     "MARS SMURFLoader.cpp:616-621, run"},
};

}  // namespace

extern constinit const Rule sml5012_unnamed_entity{
    .id = "SML5012",
    .name = "unnamed-entity",
    .severity = Severity::warning,
    .summary = "An entity has no name.",
    .why = "Nothing can be placed on it or anchored to it, and plug-ins do not find it.",
    .remedy = "Give it a name that no other entity has.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5012_unnamed_entity_file
