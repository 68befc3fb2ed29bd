// SPDX-License-Identifier: BSD-3-Clause
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    // Without a type nobody can load it, which is another finding.
    if (entity.file.written || entity.uri.written || !entity.type.written) return;
    findings.report(type_place(entity), title(entity) + " has a type and no file");
  });
}

}  // namespace

extern constinit const Rule sml7107_entity_of_plugin{
    .id = "SML7107",
    .name = "entity-of-plugin",
    .severity = Severity::error,
    .summary = "An entity has no file, which a target asks for.",
    .why = "MARS hands it to the plug-in or primitive of its type. Phobos 2 stops with an "
           "assertion, its pybullet script with a KeyError.",
    .remedy = "Keep such entities in a scene of their own.",
    .sources = "MARS EntityFactoryManager.cpp:68-86; Phobos core/multiple.py.",
    .check_scene = check,
    .needs_target = true};

}  // namespace smurf::rules
