// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7106_urdf_entity_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (!entity.file || path::to_lower(path::extension(*entity.file)) != ".urdf") return;
    findings.report(entity.file.span, title(entity) + " is a URDF")
        .help("name a .smurf that lists it");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "loads it", "read"},
    {&readers::mars2, Effect::refuses, "reports an error and stops loading the scene",
     "MarsSceneLoader.cpp:206-226"},
    {&readers::phobos, Effect::takes, "loads it", "read"},
};

}  // namespace

extern constinit const Rule sml7106_urdf_entity{
    .id = "SML7106",
    .name = "urdf-entity",
    .severity = Severity::error,
    .summary = "An entity is a URDF, which a target does not load.",
    .remedy = "Write a .smurf whose `files` list the URDF.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7106_urdf_entity_file
