// SPDX-License-Identifier: BSD-3-Clause
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

}  // namespace

extern constinit const Rule sml3105_unknown_motor{
    .id = "SML3105",
    .name = "unknown-motor",
    .severity = Severity::error,
    .summary = "An annotation names a motor that the model does not have.",
    .why = "MARS looks names up in a map that answers 0 for unknown ones: the target is dropped "
           "from the sensor or controller; an unknown leader of a mimic adds its offset in every "
           "step.",
    .remedy = "Correct the name.",
    .sources = "MARS smurf.cpp:155-181, 465-480; MotorManager.cpp:537-544; SimMotor.cpp:356.",
    .check_model = check};

}  // namespace smurf::rules
