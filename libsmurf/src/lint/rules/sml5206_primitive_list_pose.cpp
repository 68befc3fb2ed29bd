// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5206_primitive_list_pose_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_use(scene, [&](const Use& use) {
    const Entity& entity = use.entity;
    if (entity_type(entity) != "primitive" || use.is_nested()) return;
    const bool is_position = entity.position.written && !entity.position_is_mapping;
    const bool is_rotation =
        entity.rotation.form != RotationForm::absent && !entity.rotation.is_mapping;
    if (!is_position && !is_rotation) return;
    Diagnostic& diagnostic =
        findings.report(is_position ? entity.position.span : entity.rotation.span,
                        is_position ? "the position of a primitive must be a mapping"
                                    : "the rotation of a primitive must be a mapping");
    if (is_position && entity.position) {
      const auto& [x, y, z] = *entity.position;
      diagnostic.help("write {x: " + format_number(x) + ", y: " + format_number(y) +
                      ", z: " + format_number(z) + "}");
    } else if (!is_position && entity.rotation.form != RotationForm::invalid) {
      const Quaternion q = to_quaternion(entity.rotation);
      diagnostic.help("write {w: " + format_number(q.w) + ", x: " + format_number(q.x) +
                      ", y: " + format_number(q.y) + ", z: " + format_number(q.z) + "}");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "ends with an uncaught exception",
     "MARS primitives.cpp:148-153"},
};

}  // namespace

extern constinit const Rule sml5206_primitive_list_pose{
    .id = "SML5206",
    .name = "primitive-list-pose",
    .severity = Severity::error,
    .summary = "An entity of type primitive writes its position or rotation as a list.",
    .remedy = "Write mappings: {x: 0, y: 0, z: 1} and {w: 1, x: 0, y: 0, z: 0}.",
    .check_scene = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml5206_primitive_list_pose_file
