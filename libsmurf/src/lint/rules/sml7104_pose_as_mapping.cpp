// SPDX-License-Identifier: BSD-3-Clause
#include "lint/scene_queries.hpp"

namespace smurf::rules {
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

}  // namespace

extern constinit const Rule sml7104_pose_as_mapping{
    .id = "SML7104",
    .name = "pose-as-mapping",
    .severity = Severity::error,
    .summary = "A position or rotation is a mapping, which a target does not read.",
    .why = "MARS reads mappings since February 2025, Phobos 2 writes them; MARS 2 and the "
           "pybullet script of Phobos end with an exception.",
    .remedy = "Write `position: [x, y, z]` and `rotation: [w, x, y, z]`.",
    .sources = "MARS commit b7f50a4; MarsSceneLoader.cpp; Phobos "
               "scripts/smurfs_in_pybullet.py:115-122.",
    .check_scene = check,
    .needs_target = true};

}  // namespace smurf::rules
