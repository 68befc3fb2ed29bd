// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/utf8.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1310_not_an_identifier_file {
namespace {

constexpr Circumstance kSpace{"space"};

/// `tn__1_arm_` for `1_arm`; of names with other characters, only the beginning is known here.
std::string as_name_of_isaac(std::string_view name) {
  const std::string plain(name);
  const bool is_plain = as_identifier("a" + plain) == "a" + plain;
  return "tn__" + (is_plain ? plain + "_" : std::string("..."));
}

/// One finding per file, at the first such name, because a naming scheme is one decision.
void check(const LinkedModel& model, Findings& findings) {
  // SML1311 reports names that become equal.
  if (!name_collisions(model, as_identifier).empty()) return;
  enum Habit { with_blank, others };
  for_each_name(model, [&](std::string_view, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::irregular) return;
    // SML0004 reports control characters.
    if (!utf8::is_printable(*name)) return;
    if (name->find(' ') != std::string::npos) {
      findings
          .report_habit(name.span, "the name " + quoted(*name) + " contains a space", "such names",
                        with_blank)
          .when(kSpace)
          .note("Gazebo derives names of topics from it, which must not contain spaces")
          .severity = Severity::warning;
      return;
    }
    findings
        .report_habit(name.span,
                      "the name " + quoted(*name) +
                          " has characters other than letters, digits and underscores",
                      "such names", others)
        .note("Isaac Sim up to 5 renames it to " + quoted(as_identifier(*name)) +
              ", Isaac Sim 6 to " + quoted(as_name_of_isaac(*name)));
  });
}

constexpr Fact kFacts[] = {
    {&readers::isaac, Effect::changes,
     "renames links and joints, so that configurations of policies do not find them",
     "urdf-usd-converter 0.3.4, run; before 6, PathUtils.cpp"},
    {&readers::gazebo, Effect::loses, "refuses the topics whose names it derives from such names",
     "gz-transport TopicUtils (IsValidTopic)", when(kSpace)},
};

}  // namespace

extern constinit const Rule sml1310_not_an_identifier{
    .id = "SML1310",
    .name = "not-an-identifier",
    .severity = Severity::info,
    .summary = "Names contain characters that some targets replace.",
    .why =
        "USD accepts letters, digits and underscores only: `-`, `.` and spaces become "
        "`_`, or part of a code, a leading digit gets a prefix, and mimic joints and controllers that refer to the "
        "old name no longer find it. Code generators and Modelica do the same.",
    .remedy = "Use letters, digits and underscores, and do not begin with a digit.",
    .sources = "Isaac importer PathUtils.cpp:356-369 and "
               "UrdfParser.cpp:352; 156 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1310_not_an_identifier_file
