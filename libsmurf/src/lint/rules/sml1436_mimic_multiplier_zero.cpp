// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1436_mimic_multiplier_zero_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.mimic || joint.mimic->multiplier.value_or(1) != 0) return;
    findings
        .report(joint.mimic->multiplier.span, "the mimic multiplier of " + title(joint) + " is 0")
        .note("Phobos uses 1 instead");
  });
}

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::changes, "treats 0 as absent and multiplies by 1",
     "Phobos io/representation.py:1975"},
};

}  // namespace

extern constinit const Rule sml1436_mimic_multiplier_zero{
    .id = "SML1436",
    .name = "mimic-multiplier-zero",
    .severity = Severity::warning,
    .summary = "The multiplier of a mimic joint is 0.",
    .why = "The joint never moves.",
    .remedy = "Make the joint fixed, or write the multiplier that is meant.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1436_mimic_multiplier_zero_file
