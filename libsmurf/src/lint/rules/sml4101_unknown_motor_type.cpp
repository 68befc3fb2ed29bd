// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/known_words.hpp"
#include "base/findings/readers.hpp"
#include "base/text/suggest.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml4101_unknown_motor_type_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.type) continue;
    const auto is_type = [&](std::string_view type) { return type == *motor.type; };
    if (std::any_of(std::begin(kMotorTypes), std::end(kMotorTypes), is_type)) continue;
    Diagnostic& diagnostic =
        findings.report(motor.type.span, quoted(*motor.type) + " is not a motor type");
    diagnostic.note("MARS runs " + subject("motor", motor) + " as a position controller");
    diagnostic.help("known types: PID, DC, generic_bldc, generic_dc, direct_torque, direct_effort");
    if (const auto near = only_nearest(*motor.type, kMotorTypes)) {
      diagnostic.help("did you mean " + quoted(*near) + "?");
      diagnostic.fixes.push_back(
          {Applicability::unsafe, {{within_quotes(model, motor.type.span), std::string(*near)}}});
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "treats it as a position controller",
     "MARS MotorData.cpp:126-135"},
    {&readers::mars2, Effect::loses, "skips this and all following motors",
     "envire_smurf_loader Model.cpp"},
    {&readers::envire, Effect::changes, "treats it as a position controller",
     "MARS MotorData.cpp:126-135"},
    {&readers::phobos, Effect::takes, "keeps the word", kRun},
};

}  // namespace

extern constinit const Rule sml4101_unknown_motor_type{
    .id = "SML4101",
    .name = "unknown-motor-type",
    .severity = Severity::error,
    .summary = "A motor has a type that no reader knows.",
    .remedy = "Use one of the known types; they are case-sensitive.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4101_unknown_motor_type_file
