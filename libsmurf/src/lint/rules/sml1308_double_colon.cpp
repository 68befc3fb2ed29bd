// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1308_double_colon_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_name(model, [&](std::string_view kind, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::double_colon) return;
    findings.report(name.span, "the name " + quoted(*name) + " of a " + std::string(kind) +
                                   " contains `::`, which Gazebo reads as a path");
  });
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::changes,
     "looks for such a link or joint in a nested model, which does not exist",
     "SDFormat specification, frame semantics: names and scopes"},
};

}  // namespace

extern constinit const Rule sml1308_double_colon{.id = "SML1308",
                                                 .name = "double-colon",
                                                 .severity = Severity::warning,
                                                 .summary = "A name contains `::`.",
                                                 .remedy = "Use `_` instead.",
                                                 .check_model = check,
                                                 .facts = kFacts};

}  // namespace smurf::rules::sml1308_double_colon_file
