// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1309_slash_in_name_file {
namespace {

constexpr Circumstance kLeading{"leading slash"};

/// One finding per file, because authors name all parts by one scheme.
void check(const LinkedModel& model, Findings& findings) {
  for_each_name(model, [&](std::string_view, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::slash) return;
    Diagnostic& finding = findings.report_habit(
        name.span, "the name " + quoted(*name) + " contains a slash", "such names");
    finding.note("MuJoCo and USD treat it as the separator of a path");
    if (name->starts_with('/')) finding.when(kLeading);
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::changes,
     "tf2 strips a leading slash, and refuses look-ups of names that begin with one",
     "tf2 1b005c65 buffer_core.cpp", when(kLeading)},
    {&readers::ros, Effect::takes, "tf2 treats a slash inside a name as any other character",
     "tf2 1b005c65 buffer_core.cpp"},
    {&readers::mujoco, Effect::changes, "treats `/` as the separator of attached models",
     "MuJoCo xml_urdf.cc:81"},
};

}  // namespace

extern constinit const Rule sml1309_slash_in_name{
    .id = "SML1309",
    .name = "slash-in-name",
    .severity = Severity::warning,
    .summary = "A name contains a slash.",
    .why = "USD treats `/` as the separator of paths.",
    .remedy = "Use `_` instead.",
    .sources = "32 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1309_slash_in_name_file
