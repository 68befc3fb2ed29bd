// SPDX-License-Identifier: BSD-3-Clause
#include "lint/name_queries.hpp"

namespace smurf::rules {
namespace {

/// A naming scheme is one decision, so a file has one finding, at the first such name.
void check(const LinkedModel& model, Findings& findings) {
  std::size_t count = 0;
  const Field<std::string>* first = nullptr;
  for_each_name(model, [&](std::string_view, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::irregular) return;
    if (count++ == 0) first = &name;
  });
  // Names that even become equal have a rule of their own.
  if (first == nullptr || !name_collisions(model, as_identifier).empty()) return;
  Diagnostic& diagnostic =
      findings.report(first->span, "the name " + quoted(**first) +
                                       " is not of letters, digits and underscores only");
  diagnostic.notes.push_back("Isaac and USD rename it to " + quoted(as_identifier(**first)));
  if (count > 1) {
    diagnostic.notes.push_back("the file holds " + std::to_string(count - 1) + " more such names");
  }
}

}  // namespace

extern constinit const Rule sml1310_not_an_identifier{
    .id = "SML1310",
    .name = "not-an-identifier",
    .severity = Severity::info,
    .summary = "Names hold characters that some targets replace.",
    .why = "Isaac and USD take letters, digits and underscores only: `-`, `.` and blanks become "
           "`_`, a digit in front gets a prefix, and what refers to the old name (mimic joints, "
           "controllers) no longer finds it. Code generators and Modelica do likewise.",
    .remedy = "Use letters, digits and underscores, and no digit in front.",
    .sources = "Isaac importer PathUtils.cpp:356-369 and UrdfParser.cpp:352; 156 of 322 files of "
               "the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules
