// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3201_motor_on_immovable_joint_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    const urdf::Joint* joint = joint_of(model, motor);
    if (joint == nullptr || joint->has_one_axis() || joint->type == urdf::JointType::unknown)
      continue;
    Diagnostic& diagnostic =
        findings.report(motor.joint.span, subject("motor", motor) + " drives " + title(*joint) +
                                              ", which is " + *joint->type_name);
    if (joint->type != urdf::JointType::fixed) diagnostic.note("MARS makes it fixed");
    diagnostic.label(joint->type_name.span, "the type of the joint");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "makes floating and planar joints fixed; the motor has no effect", "MARS smurf.cpp:893-939"},
};

}  // namespace

extern constinit const Rule sml3201_motor_on_immovable_joint{
    .id = "SML3201",
    .name = "motor-on-immovable-joint",
    .severity = Severity::warning,
    .summary = "A motor drives a joint that does not move.",
    .why = "A fixed joint stays fixed in every reader.",
    .remedy = "Drive another joint, or change the type of this one.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3201_motor_on_immovable_joint_file
