// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/habit.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1309_slash_in_name_file {
namespace {

/// One finding per file, because authors name all parts by one scheme.
void check(const LinkedModel& model, Findings& findings) {
  Habit habit;
  for_each_name(model, [&](std::string_view, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::slash) return;
    habit.add(name.span, "the name " + quoted(*name) + " contains a slash");
  });
  Diagnostic* diagnostic = habit.report("such names", findings);
  if (diagnostic == nullptr) return;
  diagnostic->note("MuJoCo, tf2 and USD treat it as the separator of a path");
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::changes, "tf2 treats `/` as the separator of frames",
     "tf2 frame names"},
    {&readers::mujoco, Effect::changes, "treats `/` as the separator of attached models",
     "MuJoCo xml_urdf.cc:81"},
};

constexpr std::string_view kFormer[] = {"slash"};

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
    .facts = kFacts,
    .former = kFormer};

}  // namespace smurf::rules::sml1309_slash_in_name_file
