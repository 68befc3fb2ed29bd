// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml7104_pose_as_mapping_file {
namespace {

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile&, const Entity& entity) {
    if (entity.position_is_mapping) {
      findings.report(entity.position.span, "the position of " + title(entity) + " is a mapping");
    } else if (entity.rotation.is_mapping) {
      findings.report(entity.rotation.span, "the rotation of " + title(entity) + " is a mapping");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "reads mappings since February 2025", "MARS commit b7f50a4"},
    {&readers::mars2, Effect::crashes, "ends with an uncaught exception", "MarsSceneLoader.cpp"},
    {&readers::phobos, Effect::takes, "writes and reads them", "Phobos, read"},
    {&readers::pybullet, Effect::crashes, "stops with an exception",
     "Phobos scripts/smurfs_in_pybullet.py:115-122, run"},
};

}  // namespace

extern constinit const Rule sml7104_pose_as_mapping{
    .id = "SML7104",
    .name = "pose-as-mapping",
    .severity = Severity::error,
    .summary = "A position or rotation is a mapping, which a target does not read.",
    .remedy = "Write `position: [x, y, z]` and `rotation: [w, x, y, z]`.",
    .check_scene = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7104_pose_as_mapping_file
