// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3107_unknown_sensor_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_unknown(model, NameKind::sensor, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "runs the controller without it",
     "MARS ControllerData.cpp:55-77"},
};

}  // namespace

extern constinit const Rule sml3107_unknown_sensor{
    .id = "SML3107",
    .name = "unknown-sensor",
    .severity = Severity::error,
    .summary = "A controller names a sensor that the model does not have.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3107_unknown_sensor_file
