// SPDX-License-Identifier: BSD-3-Clause
#include "lint/name_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_name(model, [&](std::string_view kind, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::double_colon) return;
    findings.report(name.span, "the name " + quoted(*name) + " of a " + std::string(kind) +
                                   " holds `::`, which Gazebo reads as a path");
  });
}

}  // namespace

extern constinit const Rule sml1308_double_colon{
    .id = "SML1308",
    .name = "double-colon",
    .severity = Severity::warning,
    .summary = "A name holds `::`.",
    .why = "sdformat (Gazebo) separates the names of nested models by it, so such a link or joint "
           "is looked up in a model that does not exist.",
    .remedy = "Use `_` instead.",
    .sources = "SDFormat specification, frame semantics: names and scopes.",
    .check_model = check};

}  // namespace smurf::rules
