// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7107_entity_of_plugin_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    // Without a type no reader can load it: SML5005.
    if (entity.file.written || entity.uri.written || !entity.type.written) return;
    findings.report(type_place(entity), title(entity) + " has a type and no file");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "passes it to the plug-in or primitive of its type",
     "MARS EntityFactoryManager.cpp:68-86"},
    {&readers::phobos, Effect::refuses, "stops with an assertion", "Phobos core/multiple.py"},
    {&readers::pybullet, Effect::crashes, "stops with a KeyError",
     "Phobos scripts/smurfs_in_pybullet.py, run"},
};

}  // namespace

extern constinit const Rule sml7107_entity_of_plugin{
    .id = "SML7107",
    .name = "entity-of-plugin",
    .severity = Severity::error,
    .summary = "An entity has no file, which a target requires.",
    .remedy = "Put such entities into a separate scene.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7107_entity_of_plugin_file
