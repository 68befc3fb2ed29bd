// SPDX-License-Identifier: BSD-3-Clause
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  if (scene.schemas == nullptr) return;
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    scene.schemas->check_entity(entity_type(entity), mapping_of(file, entity), findings);
  });
}

}  // namespace

extern constinit const Rule sml5401_entity_against_schema{
    .id = "SML5401",
    .name = "entity-against-schema",
    .severity = Severity::error,
    .summary = "An entity breaks the schema that was registered for its type.",
    .why = "The plug-in that makes entities of this type describes by its schema what it "
           "understands; what it makes of anything else is unknown.",
    .remedy = "Change the value, or the schema when it is too strict.",
    .sources = "The schema that the label names.",
    .check_scene = check};

}  // namespace smurf::rules
