// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3105_unknown_motor_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_unknown(model, NameKind::motor, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "drops the target from the sensor or controller; for an unknown leader of a mimic it adds the offset in every step",
     "MARS smurf.cpp:155-181, 465-480; MotorManager.cpp:537-544; SimMotor.cpp:356"},
    {&readers::phobos, Effect::loses, "finds no such motor, and goes on", kRun},
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

}  // namespace smurf::rules::sml3105_unknown_motor_file
