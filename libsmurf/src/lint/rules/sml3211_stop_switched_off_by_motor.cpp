// SPDX-License-Identifier: BSD-3-Clause

#include <map>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3211_stop_switched_off_by_motor_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string_view, const Motor*> motors;
  for (const Motor& motor : model.annotations.motors) {
    if (motor.joint) motors.emplace(*motor.joint, &motor);
  }
  for (const JointAnnotation& entry : model.annotations.joints) {
    const urdf::Joint* joint = entry.name ? model.find_joint(*entry.name) : nullptr;
    const auto motor = entry.name ? motors.find(*entry.name) : motors.end();
    if (joint == nullptr || motor == motors.end()) continue;
    const bool is_hinge =
        joint->type == urdf::JointType::revolute || joint->type == urdf::JointType::continuous;
    if (!is_hinge || control_in_mars(*motor->second) == MotorControl::torque) continue;
    if (!entry.low_stop || *entry.low_stop == 0) continue;  // it has no effect anyway
    Diagnostic& diagnostic =
        findings.report(mapping_of(model, entry).find("lowStopAxis1").key_span(),
                        "the stops of " + title(*joint) + " have no effect in MARS: " +
                            subject("motor", *motor->second) + " switches them off");
    diagnostic.label(motor->second->joint.span, "driven here");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "removes both stops of a hinge as soon as a position or velocity motor is attached to it",
     "MARS SimMotor.cpp:768-772, JointPhysics.cpp:695-700"},
};

}  // namespace

extern constinit const Rule sml3211_stop_switched_off_by_motor{
    .id = "SML3211",
    .name = "stop-switched-off-by-motor",
    .severity = Severity::warning,
    .summary = "A joint has stops and a motor that switches them off.",
    .why =
        "Only the bounds of the motor remain. Sliders keep their stops, and so do hinges with a torque motor.",
    .remedy = "Give the motor bounds, and delete the stops.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3211_stop_switched_off_by_motor_file
