// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3212_stops_not_negated_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const JointAnnotation& entry : model.annotations.joints) {
    const urdf::Joint* joint = entry.name ? model.find_joint(*entry.name) : nullptr;
    if (joint == nullptr || !joint->limit || !entry.low_stop || !entry.high_stop) continue;
    const Field<double>& lower = joint->limit->lower;
    const Field<double>& upper = joint->limit->upper;
    if (!lower || !upper || *lower == -*upper || *entry.low_stop == 0) continue;
    if (*entry.low_stop != *lower || *entry.high_stop != *upper) continue;
    Diagnostic& diagnostic =
        findings.report(entry.low_stop.span, "MARS keeps " + title(*joint) + " between " +
                                                 format_number(-*entry.high_stop) + " and " +
                                                 format_number(-*entry.low_stop));
    diagnostic.label(lower.span, "the URDF's limits have the other sign");
    diagnostic.help("write `lowStopAxis1: " + format_number(-*upper) +
                    "` and `highStopAxis1: " + format_number(-*lower) + "`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "attaches the parent as first body, so the position of the URDF stays between -highStopAxis1 and -lowStopAxis1",
     "MARS JointPhysics.cpp:336-347, run"},
};

}  // namespace

extern constinit const Rule sml3212_stops_not_negated{
    .id = "SML3212",
    .name = "stops-not-negated",
    .severity = Severity::warning,
    .summary = "The stops of a joint are the limits of the URDF without the change of sign.",
    .why = "The limits must change sign and places.",
    .remedy = "Write `lowStopAxis1` = -upper and `highStopAxis1` = -lower.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3212_stops_not_negated_file
