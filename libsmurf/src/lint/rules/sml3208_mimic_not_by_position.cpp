// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3208_mimic_not_by_position_file {
namespace {

bool takes_positions(const Motor& motor) {
  return control_in_mars(motor) == MotorControl::position;
}

/// Whether the follower does what its leader does, so that nothing needs to be computed.
bool is_copy(const Motor& motor) {
  return motor.mimic_multiplier.value_or(1) == 1 && motor.mimic_offset.value_or(0) == 0;
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.mimic_motor) continue;
    const Motor* leader = model.find_motor(*motor.mimic_motor);
    if (leader == nullptr || leader == &motor) continue;  // reported
    const bool is_mixed = control_in_mars(motor) != control_in_mars(*leader);
    if (!is_mixed && (takes_positions(motor) || is_copy(motor))) continue;
    const std::string who = subject("motor", motor);
    const std::string type = quoted(motor.type.value_or("PID"));
    Diagnostic& diagnostic =
        is_mixed
            ? findings.report(motor.mimic_motor.span, who + " of type " + type +
                                                          " follows a motor of type " +
                                                          quoted(leader->type.value_or("PID")))
            : findings.report(motor.mimic_motor.span, who + " of type " + type +
                                                          " follows another one, but its "
                                                          "multiplier and offset have no effect");
    diagnostic.note(is_mixed ? "MARS gives both the same command, which means different things"
                             : "MARS uses them for motors that are commanded by position");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "passes the command of the leader on; it multiplies and offsets only positions",
     "MARS SimMotor.cpp:353-356, 444-450"},
};

}  // namespace

extern constinit const Rule sml3208_mimic_not_by_position{
    .id = "SML3208",
    .name = "mimic-not-by-position",
    .severity = Severity::warning,
    .summary = "A motor follows another one, and the two are not commanded by position.",
    .why = "The joint then turns in a wrong direction, or by a wrong amount.",
    .remedy = "Give both motors the type `PID`, or command both of them in the controller.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3208_mimic_not_by_position_file
