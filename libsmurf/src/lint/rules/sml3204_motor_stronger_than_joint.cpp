// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3204_motor_stronger_than_joint_file {
namespace {

struct Pair {
  const Field<double>& of_motor;
  const Field<double>& of_joint;
  std::string_view key, attribute;
};

void check_pair(const Motor& motor, const urdf::Joint& joint, const Pair& pair,
                Findings& findings) {
  if (!pair.of_motor || !pair.of_joint || *pair.of_joint <= 0) return;  // 0 is reported in the URDF
  // Data of motors are rarely more accurate than 10 %.
  const double noticeable = findings.tolerance();
  if (*pair.of_motor <= noticeable * *pair.of_joint) return;
  Diagnostic& diagnostic = findings.report(
      pair.of_motor.span, quoted(pair.key) + " of " + subject("motor", motor) + " is " +
                              format_rounded(*pair.of_motor) + ", but the " +
                              std::string(pair.attribute) + " limit of " + title(joint) + " is " +
                              format_rounded(*pair.of_joint));
  diagnostic.label(pair.of_joint.span, "the limit of the joint");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor* leading : leading_motors(model)) {
    const Motor& motor = *leading;
    const urdf::Joint* joint = joint_of(model, motor);
    if (joint == nullptr || !joint->limit) continue;
    check_pair(motor, *joint, {motor.max_effort, joint->limit->effort, "maxEffort", "effort"},
               findings);
    check_pair(motor, *joint, {motor.max_speed, joint->limit->velocity, "maxSpeed", "velocity"},
               findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "uses the effort and speed of the motor only",
     "MARS smurf.cpp:902-910"},
    {&readers::phobos, Effect::takes, "uses those of the joint's limit",
     "Phobos representation.py:2399, run"},
};

}  // namespace

extern constinit const Rule sml3204_motor_stronger_than_joint{
    .id = "SML3204",
    .name = "motor-stronger-than-joint",
    .severity = Severity::warning,
    .summary = "A motor is stronger or faster than the URDF allows its joint to be.",
    .why =
        "Readers of the URDF use the limits of the joint, so the robot behaves differently there.",
    .remedy = "Make the two agree.",
    .check_model = check,
    .tolerance = {.value = 1.1,
                  .meaning = "how many times as strong or fast as the joint allows a motor may be"},
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3204_motor_stronger_than_joint_file
