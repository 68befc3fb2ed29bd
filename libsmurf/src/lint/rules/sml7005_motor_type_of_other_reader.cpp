// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.type) continue;
    findings.report(motor.type.span, subject("motor", motor) + " is of type " + quoted(*motor.type))
        .construct = *motor.type;
  }
}

}  // namespace

extern constinit const Rule sml7005_motor_type_of_other_reader{
    .id = "SML7005",
    .name = "motor-type-of-other-reader",
    .severity = Severity::error,
    .summary = "A motor has a type that a target does not know, but another reader does.",
    .why = "MARS knows PID, DC, generic_bldc, generic_dc, direct_torque and direct_effort; MARS "
           "2 PID, DC, DirectEffort and FeedForwardEffort; Phobos 2 writes position, velocity "
           "and force. MARS runs a motor of any other type as a position controller, MARS 2 "
           "skips it and all that follow.",
    .remedy = "Use a type that all targets know: PID or DC.",
    .sources =
        "MARS MotorData.cpp:126-135, SimMotor.cpp:290; envire_smurf_loader Model.cpp:455-478; "
        "Phobos representation.py.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
