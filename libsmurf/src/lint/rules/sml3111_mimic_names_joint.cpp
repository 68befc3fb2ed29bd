// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!can_judge(model, NameKind::motor)) return;
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.mimic_motor || model.motor_names.contains(*motor.mimic_motor)) continue;
    const urdf::Joint* joint = find_joint(model, *motor.mimic_motor);
    if (joint == nullptr) continue;
    Diagnostic& diagnostic = findings.report(motor.mimic_motor.span,
                                             "MARS knows no motor " + quoted(*motor.mimic_motor) +
                                                 ": it is a joint, which only Phobos takes");
    diagnostic.labels.push_back({joint->name.span, "the joint is defined here"});
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "looks for a motor of that name; when there is none, the motor adds its offset in every step and drifts away",
     "MARS MotorManager.cpp:537-544, SimMotor.cpp:356"},
    {&readers::phobos, Effect::takes, "writes and reads the name of the joint that is mimicked",
     "Phobos representation.py:2399"},
};

}  // namespace

extern constinit const Rule sml3111_mimic_names_joint{
    .id = "SML3111",
    .name = "mimic-names-joint",
    .severity = Severity::warning,
    .summary = "A motor mimics a joint, where MARS needs a motor.",
    .remedy = "Give the leading motor the name of its joint, which both understand.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
