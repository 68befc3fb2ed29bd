// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4105_mimic_multiplier_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.mimic_motor.written) continue;
    if (motor.mimic_multiplier && *motor.mimic_multiplier == 0) {
      findings.report(motor.mimic_multiplier.span,
                      subject("motor", motor) + " does not follow: its factor is 0");
    }
    if (motor.mimic_multiplier.written) continue;
    const yaml::View mapping = mapping_of(model, motor);
    if (!mapping || has_misspelt(mapping, "mimic_multiplier")) continue;
    findings
        .report(mapping.find("mimic_motor").key_span(), subject("motor", motor) +
                                                            " does not follow in MARS: without "
                                                            "`mimic_multiplier` the factor is 0")
        .help("add `mimic_multiplier: 1.0`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "enables the mimic by `mimic_motor` and reads the absent multiplier as 0: the motor stays at `mimic_offset`",
     "MARS MotorManager.cpp:104-109"},
    {&readers::phobos, Effect::takes, "keeps the motor", kRun},
};

}  // namespace

extern constinit const Rule sml4105_mimic_multiplier_missing{
    .id = "SML4105",
    .name = "mimic-multiplier-missing",
    .severity = Severity::error,
    .summary = "A motor mimics another one without `mimic_multiplier`, or with 0.",
    .why = "The URDF default of 1 does not apply.",
    .remedy = "Write `mimic_multiplier: 1.0`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4105_mimic_multiplier_missing_file
