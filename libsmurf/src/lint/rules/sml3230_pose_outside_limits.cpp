// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/angle_queries.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3230_pose_outside_limits_file {
namespace {

void check_entry(const LinkedModel& model, const JointPoseSet::Entry& entry, Findings& findings) {
  const urdf::Joint* joint = joint_of(model, entry);
  if (joint == nullptr || !joint->limit || !entry.position) return;
  if (joint->type == urdf::JointType::continuous) return;
  const double position = *entry.position;
  const Field<double>& lower = joint->limit->lower;
  const Field<double>& upper = joint->limit->upper;
  if (!lower || !upper || *lower >= *upper) return;
  const bool is_angle = joint->type == urdf::JointType::revolute;
  if (is_angle && looks_like_degrees(position)) return;  // SML4117
  const bool is_below = is_clearly_less(position, *lower);
  if (!is_below && !is_clearly_less(*upper, position)) return;
  const Field<double>& limit = is_below ? lower : upper;
  Diagnostic& diagnostic =
      findings.report(entry.position.span, "the position " + format_number(position) + " lies " +
                                               (is_below ? "below" : "above") + " the limit " +
                                               format_number(*limit) + " of " + title(*joint));
  diagnostic.label(limit.span, "the limit");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const JointPoseSet& pose : model.annotations.poses) {
    for (const JointPoseSet::Entry& entry : pose.joints) check_entry(model, entry, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "moves the joint there without looking at the limits",
     "MARS SimEntity.cpp:503-513, SimJoint.cpp:524-528"},
    {&readers::phobos, Effect::changes, "clamps the position to the limits", "Phobos io/poses.py"},
};

}  // namespace

extern constinit const Rule sml3230_pose_outside_limits{
    .id = "SML3230",
    .name = "pose-outside-limits",
    .severity = Severity::warning,
    .summary = "A joint pose lies outside the limits of the joint.",
    .remedy = "Correct the position, or the limits.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3230_pose_outside_limits_file
