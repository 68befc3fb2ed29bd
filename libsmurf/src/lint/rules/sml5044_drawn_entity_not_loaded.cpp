// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5044_drawn_entity_not_loaded_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    if (!file.drawing) return;
    const std::string type = entity_type(entity);
    const bool is_primitive = type == "primitive";
    if (kind_of(type) == EntityKind::other && !is_old_scene(type) && !is_primitive) return;
    findings.report(type_place(entity), is_primitive ? "MARS gives a primitive of a drawing no pose"
                                                     : "MARS loads no entity of type " +
                                                           quoted(type) + " from a drawing");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "passes the group to the plug-in of its type, with keys that only plug-ins know: a model is "
     "looked up in the root folder, and a primitive stays at the origin",
     "MARS SMURFLoader.cpp:127-302, 564-578, 580-637"},
};

}  // namespace

extern constinit const Rule sml5044_drawn_entity_not_loaded{
    .id = "SML5044",
    .name = "drawn-entity-not-loaded",
    .severity = Severity::warning,
    .summary = "A drawn scene contains an entity that MARS does not load or place from a drawing.",
    .why = "smurfs-flatten places the entity as it is drawn.",
    .remedy = "Flatten the drawing to a .smurfs (`smurfs-flatten --format smurfs`), or use a type "
              "of your own.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5044_drawn_entity_not_loaded_file
