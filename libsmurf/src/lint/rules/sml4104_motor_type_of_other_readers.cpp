// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4104_motor_type_of_other_readers_file {
namespace {

struct Foreign {
  std::string_view type, reader, in_mars;
};
constexpr Foreign kForeign[] = {{"velocity", "Phobos", "DC"},
                                {"force", "Phobos", "direct_effort"},
                                {"DirectEffort", "MARS 2", "direct_effort"},
                                {"FeedForwardEffort", "MARS 2", "direct_effort"},
                                {"ff_torque", "MARS 2", "direct_effort"}};

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    for (const Foreign& foreign : kForeign) {
      if (!motor.type || *motor.type != foreign.type) continue;
      Diagnostic& diagnostic = findings.report(
          motor.type.span, "MARS treats " + quoted(foreign.type) + ", a type of " +
                               std::string(foreign.reader) + ", as a position controller");
      diagnostic.help("the type of MARS is " + quoted(foreign.in_mars));
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "treats it as a position controller",
     "MARS MotorData.cpp:126-135, SimMotor.cpp:290-297"},
};

}  // namespace

extern constinit const Rule sml4104_motor_type_of_other_readers{
    .id = "SML4104",
    .name = "motor-type-of-other-readers",
    .severity = Severity::warning,
    .summary = "A motor has a type that MARS treats as a position controller, but others do not.",
    .why =
        "One reader knows the types `velocity` and `force`; another knows `DirectEffort`, `FeedForwardEffort` and `ff_torque`.",
    .remedy = "Write `DC` for a speed or `direct_effort` for a torque, which MARS knows.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4104_motor_type_of_other_readers_file
