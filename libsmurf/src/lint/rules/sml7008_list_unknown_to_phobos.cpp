// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7008_list_unknown_to_phobos_file {
namespace {

void report(Span section, std::string_view name, Findings& findings) {
  findings.report(section, "the section " + quoted(name) + " is a list");
}

/// With an `s` or without; `controllers` are read, and stop Phobos as well.
bool is_read(std::string_view name) {
  constexpr std::string_view kRead[] = {"motors",        "sensors",      "materials",  "joints",
                                        "links",         "collisions",   "visuals",    "poses",
                                        "submechanisms", "exoskeletons", "interfaces", "submodels"};
  return std::any_of(std::begin(kRead), std::end(kRead), [&](std::string_view read) {
    return name == read || name == read.substr(0, read.size() - 1);
  });
}

void check(const LinkedModel& model, Findings& findings) {
  for (const ModelFile& file : model.files) {
    if (file.kind != ModelFile::Kind::annotation || !file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    for (const yaml::View value : root) {
      if (value.is_sequence() && !is_read(value.key())) {
        report(value.key_span(), value.key(), findings);
      }
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "ignores unknown sections", "MARS smurf.cpp:257-485"},
    {&readers::mars2, Effect::takes, "ignores unknown sections", "MARS smurf.cpp:257-485"},
    {&readers::envire, Effect::takes, "ignores unknown sections", "MARS smurf.cpp:257-485"},
    {&readers::phobos, Effect::refuses, "raises an exception",
     "Phobos io/smurfrobot.py:233-243, 376"},
};

}  // namespace

extern constinit const Rule sml7008_list_unknown_to_phobos{
    .id = "SML7008",
    .name = "list-unknown-to-phobos",
    .severity = Severity::error,
    .summary = "A list has a name that Phobos 2 does not know.",
    .remedy = "Make the section a mapping, or do not load the file with Phobos.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml7008_list_unknown_to_phobos_file
