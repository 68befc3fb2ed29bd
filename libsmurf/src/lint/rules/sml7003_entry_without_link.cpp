// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7003_entry_without_link_file {
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

constexpr Fact kFacts[] = {
    {&readers::mars2, Effect::crashes, "ends with an uncaught exception",
     "envire_smurf_loader Model.cpp:216-230", at("link")},
    {&readers::mars2, Effect::crashes, "ends with an uncaught exception",
     "envire_smurf_loader Model.cpp:443-505", at("sensors")},
    {&readers::mars2, Effect::loses, "finds no collision for it", "envire_smurf_loader Model.cpp",
     at("collision")},
    {&readers::envire, Effect::loses, "finds no collision for it", "rock-cpp/smurf Robot.cpp",
     at("collision")},
};

}  // namespace

extern constinit const Rule sml7003_entry_without_link{
    .id = "SML7003",
    .name = "entry-without-link",
    .severity = Severity::error,
    .summary = "An entry does not say in the key `link` which link it belongs to.",
    .why = "Readers match these entries by the link as well as by the name.",
    .remedy = "Add the key `link`; MARS ignores it where it does not need it.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7003_entry_without_link_file
