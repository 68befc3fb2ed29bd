// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7102_parent_ignored_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (!entity.parent || *entity.parent == "world" || entity.parent->empty()) return;
    findings.report(entity.parent.span,
                    title(entity) + " is placed relative to " + quoted(*entity.parent));
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars2, Effect::changes, "places the entity in the world frame",
     "MarsSceneLoader.cpp"},
    {&readers::pybullet, Effect::crashes, "stops with a TypeError",
     "Phobos scripts/smurfs_in_pybullet.py:149-169, run"},
};

}  // namespace

extern constinit const Rule sml7102_parent_ignored{
    .id = "SML7102",
    .name = "parent-ignored",
    .severity = Severity::warning,
    .summary = "An entity is placed relative to another entity, and a target does not support "
               "this.",
    .remedy = "Place the entity in the world frame: smurfs-flatten computes it.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7102_parent_ignored_file
