// SPDX-License-Identifier: BSD-3-Clause
#include "lint/scene_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (entity.anchor.value_or("") != "none") return;
    findings.report(entity.anchor.span, title(entity) + " has the anchor `none`").help =
        "leave the key out";
  });
}

}  // namespace

extern constinit const Rule sml7101_anchor_none{
    .id = "SML7101",
    .name = "anchor-none",
    .severity = Severity::warning,
    .summary = "An entity has the anchor `none`.",
    .why = "MARS and Phobos leave it free, as if nothing were written. MARS 2 fixes an entity "
           "with any anchor to the frame of that name, or to the world.",
    .remedy = "Leave the key out: no anchor is free for every reader.",
    .sources = "MarsSceneLoader.cpp:361-397.",
    .check_scene = check,
    .needs_target = true};

}  // namespace smurf::rules
