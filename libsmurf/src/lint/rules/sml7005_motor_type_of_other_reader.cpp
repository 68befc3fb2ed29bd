// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7005_motor_type_of_other_reader_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.type) continue;
    findings.report(motor.type.span, subject("motor", motor) + " is of type " + quoted(*motor.type))
        .construct = *motor.type;
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#PID"},
    {&readers::mars, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#DC"},
    {&readers::mars, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#generic_"},
    {&readers::mars, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#direct_"},
    {&readers::mars, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#1"},
    {&readers::mars, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#2"},
    {&readers::mars, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#7"},
    {&readers::mars, Effect::changes, "runs it as a position controller",
     "MARS MotorData.cpp:126-135, SimMotor.cpp:290"},
    {&readers::mars2, Effect::takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#PID"},
    {&readers::mars2, Effect::takes, "knows it", "envire_smurf_loader Model.cpp:455-478", "#DC"},
    {&readers::mars2, Effect::takes, "knows it", "envire_smurf_loader Model.cpp:455-478",
     "#DirectEffort"},
    {&readers::mars2, Effect::takes, "knows it", "envire_smurf_loader Model.cpp:455-478",
     "#FeedForwardEffort"},
    {&readers::mars2, Effect::takes, "knows it", "envire_smurf_loader Model.cpp:455-478",
     "#direct_effort"},
    {&readers::mars2, Effect::takes, "knows it", "envire_smurf_loader Model.cpp:455-478",
     "#ff_torque"},
    {&readers::mars2, Effect::takes, "knows it", "envire_smurf_loader Model.cpp:455-478",
     "#position"},
    {&readers::mars2, Effect::loses, "skips this and all following motors",
     "envire_smurf_loader Model.cpp:455-478"},
    {&readers::envire, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#PID"},
    {&readers::envire, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#DC"},
    {&readers::envire, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#generic_"},
    {&readers::envire, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", "#direct_"},
    {&readers::envire, Effect::changes, "treats it as a position controller",
     "MARS MotorData.cpp:126-135"},
};

}  // namespace

extern constinit const Rule sml7005_motor_type_of_other_reader{
    .id = "SML7005",
    .name = "motor-type-of-other-reader",
    .severity = Severity::error,
    .summary = "A motor has a type that a target does not know, but another reader does.",
    .remedy = "Use a type that all targets know: PID or DC.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7005_motor_type_of_other_reader_file
