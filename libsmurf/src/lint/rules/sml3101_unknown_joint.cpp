// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3101_unknown_joint_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_unknown(model, NameKind::joint, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::breaks, "drives nothing, and crashes when a value is set",
     "MARS smurf.cpp:264, SimMotor.cpp:786-806", at("motors")},
    {&readers::phobos, Effect::ignores, "ignores the entry", "Phobos, run", at("joint/name")},
    {&readers::phobos, Effect::ignores, "ignores the entry", "Phobos, run", at("joints/name")},
    {&readers::phobos, Effect::loses, "drops the motor, and logs another one", kRun,
     when(cases::kLaterMotor)},
    {&readers::phobos, Effect::refuses,
     "stops with an UnboundLocalError at the first motor, and elsewhere with an assertion",
     "Phobos io/smurfrobot.py:211-215, run"},
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

}  // namespace smurf::rules::sml3101_unknown_joint_file
