// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7101_anchor_none_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (entity.anchor.value_or("") != "none") return;
    findings.report(entity.anchor.span, title(entity) + " has the anchor `none`")
        .help("leave the key out");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "leaves the entity free", "read"},
    {&readers::mars2, Effect::changes, "fixes the entity to the world",
     "MarsSceneLoader.cpp:361-397"},
    {&readers::phobos, Effect::takes, "leaves the entity free", "read"},
};

}  // namespace

extern constinit const Rule sml7101_anchor_none{
    .id = "SML7101",
    .name = "anchor-none",
    .severity = Severity::warning,
    .summary = "An entity has the anchor `none`.",
    .remedy = "Leave the key out: without an anchor, the entity is free in every reader.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7101_anchor_none_file
