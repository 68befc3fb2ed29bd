// SPDX-License-Identifier: BSD-3-Clause
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!can_judge(model, NameKind::motor)) return;
  for (const JointPoseSet& pose : model.annotations.poses) {
    for (const JointPoseSet::Entry& entry : pose.joints) {
      if (model.motor_names.contains(entry.name.value)) continue;
      check_reference(model, NameKind::joint, entry.name.value, entry.name.span,
                      subject("joint pose", pose), findings);
    }
  }
}

}  // namespace

extern constinit const Rule sml3109_unknown_pose_joint{
    .id = "SML3109",
    .name = "unknown-pose-joint",
    .severity = Severity::error,
    .summary = "A joint pose names neither a motor nor a joint of the model.",
    .why = "MARS looks the names up among the motors and does nothing for an unknown one; "
           "Phobos looks among the joints.",
    .remedy = "Correct the name.",
    .sources = "MARS SimEntity.cpp:505-511; Phobos io/poses.py.",
    .check_model = check};

}  // namespace smurf::rules
