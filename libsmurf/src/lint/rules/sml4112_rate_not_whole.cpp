// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4112_rate_not_whole_file {
namespace {

void check_rate(const Field<double>& rate, const Subject& who, Findings& findings) {
  if (!rate || *rate < 0 || std::trunc(*rate) == *rate) return;
  findings
      .report(rate.span,
              "MARS reads the rate of " + who + " as " + format_number(std::trunc(*rate)) + " ms")
      .help("a rate is a period in whole milliseconds");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    check_rate(sensor.rate, subject("sensor", sensor), findings);
  }
  for (const Controller& controller : model.annotations.controllers) {
    check_rate(controller.rate, subject("controller", controller), findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "reads `rate` as an unsigned whole number and cuts off the rest: 0.5 is 0, which means every step",
     "MARS IDListConfig.h:60, Controller.cpp:173; configmaps, run"},
};

}  // namespace

extern constinit const Rule sml4112_rate_not_whole{
    .id = "SML4112",
    .name = "rate-not-whole",
    .severity = Severity::warning,
    .summary = "A rate is not a whole number of milliseconds.",
    .why = "For some readers a rate is a period, for others it is in Hz.",
    .remedy = "Write whole milliseconds.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4112_rate_not_whole_file
