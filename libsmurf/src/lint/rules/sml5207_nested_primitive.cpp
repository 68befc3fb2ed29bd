// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5207_nested_primitive_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    if (!use.inherits_in_mars() || entity_type(use.entity) != "primitive") return;
    Diagnostic& diagnostic =
        findings.report(use.entity.type.span, "MARS cannot load a primitive in an included scene");
    diagnostic.label(place_of(*scene.entity(use.around)), "the scene is included here");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "MARS NodeData.cpp:181-184"},
};

}  // namespace

extern constinit const Rule sml5207_nested_primitive{
    .id = "SML5207",
    .name = "nested-primitive",
    .severity = Severity::error,
    .summary = "An included scene contains an entity of type primitive.",
    .remedy = "Put the primitive into the outermost scene, or make it a URDF.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5207_nested_primitive_file
