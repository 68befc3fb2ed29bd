// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Controller& controller : model.annotations.controllers) {
    check_references(model, NameKind::sensor, controller.sensors, subject("controller", controller),
                     findings);
  }
}

}  // namespace

extern constinit const Rule sml3107_unknown_sensor{
    .id = "SML3107",
    .name = "unknown-sensor",
    .severity = Severity::error,
    .summary = "A controller names a sensor that the model does not have.",
    .why = "MARS looks names up in a map that answers 0 for unknown ones: the controller runs "
           "without it.",
    .remedy = "Correct the name.",
    .sources = "MARS smurf.cpp:465-480.",
    .check_model = check};

}  // namespace smurf::rules
