// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3106_unknown_visual_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  report_unknown(model, NameKind::visual, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "prints a message and ignores the entry",
     "MARS smurf.cpp:404-426"},
    {&readers::phobos, Effect::loses, "leaves the entry out", kRun},
};

}  // namespace

extern constinit const Rule sml3106_unknown_visual{
    .id = "SML3106",
    .name = "unknown-visual",
    .severity = Severity::error,
    .summary = "An annotation names a visual that the URDF does not have.",
    .remedy = "Correct the name; an annotation cannot name a visual that has no name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3106_unknown_visual_file
