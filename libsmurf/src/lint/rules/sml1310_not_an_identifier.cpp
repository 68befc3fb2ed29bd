// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/utf8.hpp"
#include "lint/habit.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1310_not_an_identifier_file {
namespace {

constexpr Circumstance kSpace{"space"};

/// One finding per file, at the first such name, because a naming scheme is one decision.
void check(const LinkedModel& model, Findings& findings) {
  // SML1311 reports names that become equal.
  if (!name_collisions(model, as_identifier).empty()) return;
  Habit with_blank, others;
  std::string renamed;
  for_each_name(model, [&](std::string_view, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::irregular) return;
    // SML0004 reports control characters.
    if (!utf8::is_printable(*name)) return;
    if (name->find(' ') != std::string::npos) {
      with_blank.add(name.span, "the name " + quoted(*name) + " contains a space");
      return;
    }
    if (others.is_first()) renamed = as_identifier(*name);
    others.add(name.span, "the name " + quoted(*name) +
                              " has characters other than letters, digits and underscores");
  });
  if (Diagnostic* diagnostic = with_blank.report("such names", findings)) {
    diagnostic->severity = Severity::warning;
    diagnostic->when(kSpace);
    diagnostic->note("Gazebo derives names of topics from it, which must not contain spaces");
  }
  if (Diagnostic* diagnostic = others.report("such names", findings)) {
    diagnostic->note("USD and Isaac rename it to " + quoted(renamed));
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "refuses the topics whose names it derives from such names",
     "gz-transport TopicUtils (IsValidTopic)", when(kSpace)},
};

}  // namespace

extern constinit const Rule sml1310_not_an_identifier{
    .id = "SML1310",
    .name = "not-an-identifier",
    .severity = Severity::info,
    .summary = "Names contain characters that some targets replace.",
    .why = "USD accepts letters, digits and underscores only: `-`, `.` and spaces become "
           "`_`, a leading digit gets a prefix, and mimic joints and controllers that refer to the "
           "old name no longer find it. Code generators and Modelica do the same.",
    .remedy = "Use letters, digits and underscores, and do not begin with a digit.",
    .sources = "Isaac importer PathUtils.cpp:356-369 and "
               "UrdfParser.cpp:352; 156 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1310_not_an_identifier_file
