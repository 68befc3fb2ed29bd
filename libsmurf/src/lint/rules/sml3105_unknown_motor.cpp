// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    const Subject who = subject("sensor", sensor);
    check_references(model, NameKind::motor, sensor.motors, who, findings);
    if (sensor.type && sensor_target(*sensor.type) == NameKind::motor) {
      check_references(model, NameKind::motor, sensor.id, who, findings);
    }
  }
  for (const Controller& controller : model.annotations.controllers) {
    check_references(model, NameKind::motor, controller.motors, subject("controller", controller),
                     findings);
  }
  for (const JointAnnotation& joint : model.annotations.joints) {
    const auto motor = text_at(mapping_of(model, joint), "motor");
    if (motor) {
      check_reference(model, NameKind::motor, motor->value, motor->span, subject("joint", joint),
                      findings);
    }
  }
  for (const Motor& motor : model.annotations.motors) {
    // Phobos writes the joint that is mimicked; another rule reports it.
    if (!motor.mimic_motor || model.joint_names.contains(*motor.mimic_motor)) continue;
    check_reference(model, NameKind::motor, *motor.mimic_motor, motor.mimic_motor.span,
                    subject("motor", motor), findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "drops the target from the sensor or controller; for an unknown leader of a mimic it adds the offset in every step",
     "MARS smurf.cpp:155-181, 465-480; MotorManager.cpp:537-544; SimMotor.cpp:356"},
};

}  // namespace

extern constinit const Rule sml3105_unknown_motor{
    .id = "SML3105",
    .name = "unknown-motor",
    .severity = Severity::error,
    .summary = "An annotation names a motor that the model does not have.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
