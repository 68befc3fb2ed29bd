// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7108_old_entity_list_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  std::set<std::pair<SourceId, EntityList>> seen;
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    if (entity.list == EntityList::entities || !file.document) return;
    if (!seen.insert({file.source, entity.list}).second) return;
    const std::string_view name = entity.list == EntityList::smurfs ? "smurfs" : "smurfa";
    const yaml::View list = file.document->view().find(name);
    if (list) findings.report(list.key_span(), "the entities are in the list " + quoted(name));
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "reads `smurfs`, `entities` and `smurfa`",
     "MARS SMURFLoader.cpp:431-450"},
    {&readers::mars2, Effect::loses, "reads `entities` only", "MarsSceneLoader.cpp"},
};

}  // namespace

extern constinit const Rule sml7108_old_entity_list{
    .id = "SML7108",
    .name = "old-entity-list",
    .severity = Severity::warning,
    .summary = "Entities are in a list that a target does not read.",
    .remedy = "Call the list `entities`.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7108_old_entity_list_file
