// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7005_motor_type_of_other_reader_file {
namespace {

constexpr Circumstance kOfMars{"a type of MARS 1"}, kOfMars2{"a type of MARS 2"},
    kOfEnvire{"a type of MARS with envire"};

void add_known(std::string_view type, Diagnostic& diagnostic) {
  const bool is_common = is_one_of(type, {"PID", "DC"}),
             is_generic = type.starts_with("generic_") || type.starts_with("direct_");
  if (is_common || is_generic || is_one_of(type, {"1", "2", "7"})) diagnostic.when(kOfMars);
  if (is_common || is_generic) diagnostic.when(kOfEnvire);
  if (is_common || is_one_of(type, {"DirectEffort", "FeedForwardEffort", "direct_effort",
                                    "ff_torque", "position"})) {
    diagnostic.when(kOfMars2);
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.type) continue;
    add_known(*motor.type,
              findings.report(motor.type.span,
                              subject("motor", motor) + " is of type " + quoted(*motor.type)));
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", when(kOfMars)},
    {&readers::mars, Effect::changes, "runs it as a position controller",
     "MARS MotorData.cpp:126-135, SimMotor.cpp:290"},
    {&readers::mars2, Effect::takes, "knows it", "envire_smurf_loader Model.cpp:455-478",
     when(kOfMars2)},
    {&readers::mars2, Effect::loses, "skips this and all following motors",
     "envire_smurf_loader Model.cpp:455-478"},
    {&readers::envire, Effect::takes, "knows it", "MARS MotorData.cpp:126-135", when(kOfEnvire)},
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
