// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1315_empty_shape_name_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (!use.name.written || !trimmed(*use.name).empty()) return;
    findings.report(use.name.span, "a " + std::string(to_string(use.role)) + " has an empty name")
        .help("name it, or delete the attribute");
  });
}

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::refuses, "refuses an empty name; accepts a shape without one", kRun},
};

}  // namespace

extern constinit const Rule sml1315_empty_shape_name{
    .id = "SML1315",
    .name = "empty-shape-name",
    .severity = Severity::error,
    .summary = "The name of a visual or collision is empty.",
    .why = "Without the attribute, readers make a name of their own.",
    .remedy = "Name it, or delete the attribute.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1315_empty_shape_name_file
