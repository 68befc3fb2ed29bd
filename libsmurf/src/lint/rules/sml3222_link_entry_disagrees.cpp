// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3222_link_entry_disagrees_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const LinkAnnotation& entry : model.annotations.links) {
    if (!entry.name || !entry.link || *entry.name == *entry.link) continue;
    Diagnostic& diagnostic =
        findings.report(entry.link.span, "MARS 2 changes the link " + quoted(*entry.link) +
                                             ", MARS and Phobos " + quoted(*entry.name));
    diagnostic.label(entry.name.span, "the name for MARS and Phobos");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "selects the link by `name`", "MARS smurf.cpp:353-365"},
    {&readers::mars2, Effect::changes, "selects the link by `link`",
     "envire_smurf_loader Model.cpp:216-230"},
    {&readers::phobos, Effect::takes, "selects the link by `name`", "Phobos, read"},
};

}  // namespace

extern constinit const Rule sml3222_link_entry_disagrees{
    .id = "SML3222",
    .name = "link-entry-disagrees",
    .severity = Severity::warning,
    .summary = "An entry of `link` names two links.",
    .why = "Each reader changes a different link.",
    .remedy = "Write the same name under both keys.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3222_link_entry_disagrees_file
