// SPDX-License-Identifier: BSD-3-Clause
#include <unordered_map>

#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  // A model without motors is not for moving in MARS.
  if (!can_judge(model, NameKind::motor) || model.annotations.motors.empty()) return;
  std::unordered_map<std::string_view, const Motor*> by_joint;
  for (const Motor& motor : model.annotations.motors) {
    if (motor.joint && motor.name) by_joint.emplace(*motor.joint, &motor);
  }
  for (const JointPoseSet& pose : model.annotations.poses) {
    for (const JointPoseSet::Entry& entry : pose.joints) {
      const std::string& name = entry.name.value;
      if (model.motor_names.contains(name) || !model.joint_names.contains(name)) continue;
      Diagnostic& diagnostic =
          findings.report(entry.name.span, "MARS does not move the joint " + quoted(name) +
                                               ": there is no motor of this name");
      const auto found = by_joint.find(name);
      if (found == by_joint.end()) continue;
      diagnostic.labels.push_back({found->second->name.span, "the motor of this joint"});
      diagnostic.help = "name the motor " + quoted(name) + ", like its joint";
    }
  }
}

}  // namespace

extern constinit const Rule sml3110_pose_joint_without_motor{
    .id = "SML3110",
    .name = "pose-joint-without-motor",
    .severity = Severity::warning,
    .summary = "A joint pose names a joint for which there is no motor of the same name.",
    .why = "MARS looks the names of a pose up among the motors: a joint without motor, or "
           "with a motor of another name, is not moved. Phobos looks among the joints.",
    .remedy = "Give the motor the name of its joint, which all readers understand.",
    .sources = "MARS SimEntity.cpp:505-511; Phobos io/poses.py.",
    .check_model = check};

}  // namespace smurf::rules
