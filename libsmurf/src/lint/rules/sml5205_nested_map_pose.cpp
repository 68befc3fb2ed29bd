// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5205_nested_map_pose_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    if (!use.inherits_in_mars() || entity_type(use.entity) == "primitive") return;
    const bool is_position = use.entity.position_is_mapping;
    if (!is_position && !use.entity.rotation.is_mapping) return;
    const std::string key = is_position ? "position" : "rotation";
    Diagnostic& diagnostic =
        findings.report(is_position ? use.entity.position.span : use.entity.rotation.span,
                        "MARS cannot compose this " + key +
                            " with the pose of the include, because it is a mapping");
    diagnostic.help(is_position ? "write [x, y, z]" : "write [w, x, y, z]");
    diagnostic.label(place_of(*scene.entity(use.around)), "the scene is included here");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "MARS SMURFLoader.cpp:688-714, run"},
};

}  // namespace

extern constinit const Rule sml5205_nested_map_pose{
    .id = "SML5205",
    .name = "nested-map-pose",
    .severity = Severity::warning,
    .summary = "An entity in an included scene writes its position or rotation as a mapping.",
    .remedy = "Write lists: [x, y, z] and [w, x, y, z].",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5205_nested_map_pose_file
