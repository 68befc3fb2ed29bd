// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1104_version_unsupported_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !model.robot->version || *model.robot->version == "1.0") return;
  Diagnostic& diagnostic =
      findings.report(model.robot->version.span, "the version " + quoted(*model.robot->version) +
                                                     " is refused by urdfdom before 5.1");
  diagnostic.help("write `1.0`, or delete the attribute");
  diagnostic.fixes.push_back({Applicability::unsafe, {{model.robot->version.span, "1.0"}}});
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::refuses, "refuses every version but 1.0",
     "urdfdom model.cpp:126-137, run"},
    {&readers::phobos, Effect::ignores, "does not look at the version", kRun},
};

}  // namespace

extern constinit const Rule sml1104_version_unsupported{
    .id = "SML1104",
    .name = "version-unsupported",
    .severity = Severity::error,
    .summary = "The version of the robot element is not 1.0.",
    .why = "\"1\" is refused too.",
    .remedy = "Delete the attribute, or write 1.0.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1104_version_unsupported_file
