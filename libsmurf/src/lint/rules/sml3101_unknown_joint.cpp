// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (motor.joint) {
      check_reference(model, NameKind::joint, *motor.joint, motor.joint.span,
                      subject("motor", motor), findings);
    }
  }
  for (const Sensor& sensor : model.annotations.sensors) {
    const Subject who = subject("sensor", sensor);
    if (sensor.joint) {
      check_reference(model, NameKind::joint, *sensor.joint, sensor.joint.span, who, findings);
    }
    check_references(model, NameKind::joint, sensor.joints, who, findings);
    if (sensor.type && sensor_target(*sensor.type) == NameKind::joint) {
      check_references(model, NameKind::joint, sensor.id, who, findings);
    }
  }
  for (const JointAnnotation& joint : model.annotations.joints) {
    if (joint.name) {
      check_reference(model, NameKind::joint, *joint.name, joint.name.span, "this joint entry",
                      findings);
    }
    const yaml::View dependencies = mapping_of(model, joint).find("joint_dependencies");
    if (!dependencies || !dependencies.is_sequence()) continue;
    for (const yaml::View dependency : dependencies) {
      if (const auto leader = text_at(dependency, "joint")) {
        check_reference(model, NameKind::joint, leader->value, leader->span,
                        subject("joint", joint), findings);
      }
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "drives nothing, and crashes when a value is set",
     "MARS smurf.cpp:264, SimMotor.cpp:786-806", "/motors/"},
    {&readers::phobos, Effect::ignores, "ignores the entry", "Phobos, run", "/joint/"},
    {&readers::phobos, Effect::refuses,
     "stops with an UnboundLocalError at the first motor, and drops any later one",
     "Phobos representation.py:2399, run"},
};

}  // namespace

extern constinit const Rule sml3101_unknown_joint{
    .id = "SML3101",
    .name = "unknown-joint",
    .severity = Severity::error,
    .summary = "An annotation names a joint that the URDF does not have.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
