// SPDX-License-Identifier: BSD-3-Clause
#include "lint/habit.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules {
namespace {

/// A naming scheme is one decision, so a file has one finding, at the first such name.
void check(const LinkedModel& model, Findings& findings) {
  // Names that even become equal have a rule of their own.
  if (!name_collisions(model, as_identifier).empty()) return;
  Habit with_blank, others;
  std::string renamed;
  for_each_name(model, [&](std::string_view, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::irregular) return;
    if (name->find(' ') != std::string::npos) {
      with_blank.add(name.span, "the name " + quoted(*name) + " holds a blank");
      return;
    }
    if (others.is_first()) renamed = as_identifier(*name);
    others.add(name.span,
               "the name " + quoted(*name) + " is not of letters, digits and underscores only");
  });
  if (Diagnostic* diagnostic = with_blank.report("such names", findings)) {
    diagnostic->severity = Severity::warning;
    diagnostic->notes.push_back("Gazebo makes names of topics of it, which take no blank");
  }
  if (Diagnostic* diagnostic = others.report("such names", findings)) {
    diagnostic->notes.push_back("Isaac and USD rename it to " + quoted(renamed));
  }
}

}  // namespace

extern constinit const Rule sml1310_not_an_identifier{
    .id = "SML1310",
    .name = "not-an-identifier",
    .severity = Severity::info,
    .summary = "Names hold characters that some targets replace.",
    .why =
        "Isaac and USD take letters, digits and underscores only: `-`, `.` and blanks become "
        "`_`, a digit in front gets a prefix, and what refers to the old name (mimic joints, "
        "controllers) no longer finds it. Code generators and Modelica do likewise. Gazebo builds "
        "the names of topics from those of joints, and refuses topics with a blank.",
    .remedy = "Use letters, digits and underscores, and no digit in front.",
    .sources =
        "gz-transport TopicUtils (IsValidTopic); Isaac importer PathUtils.cpp:356-369 and UrdfParser.cpp:352; 156 of 322 files of "
        "the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules
