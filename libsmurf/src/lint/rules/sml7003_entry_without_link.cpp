// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

template <class Entry>
void check_entries(const std::vector<Entry>& entries, std::string_view what, Findings& findings) {
  for (const Entry& entry : entries) {
    if (entry.link.written) continue;
    findings.report(entry.name.written ? entry.name.span : entry.span,
                    subject(what, entry) + " has no key `link`");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  check_entries(model.annotations.links, "link entry", findings);
  check_entries(model.annotations.sensors, "sensor", findings);
  check_entries(model.annotations.collisions, "collision entry", findings);
}

}  // namespace

extern constinit const Rule sml7003_entry_without_link{
    .id = "SML7003",
    .name = "entry-without-link",
    .severity = Severity::error,
    .summary = "An entry does not say in the key `link` which link it belongs to.",
    .why = "MARS goes by `name` and attaches some sensors to joints or motors instead. MARS 2 "
           "needs the key in every entry of `link` and `sensors` and ends with an exception; it "
           "and MARS with envire match collisions by name and link.",
    .remedy = "Add the key `link`; MARS ignores it where it does not need it.",
    .sources = "envire_smurf_loader Model.cpp:216-230, 443-456, 487-505; rock-cpp/smurf Robot.cpp.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
