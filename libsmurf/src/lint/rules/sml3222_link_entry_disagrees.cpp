// SPDX-License-Identifier: BSD-3-Clause
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const LinkAnnotation& entry : model.annotations.links) {
    if (!entry.name || !entry.link || *entry.name == *entry.link) continue;
    Diagnostic& diagnostic =
        findings.report(entry.link.span, "MARS 2 changes the link " + quoted(*entry.link) +
                                             ", MARS and Phobos " + quoted(*entry.name));
    diagnostic.labels.push_back({entry.name.span, "the name for MARS and Phobos"});
  }
}

}  // namespace

extern constinit const Rule sml3222_link_entry_disagrees{
    .id = "SML3222",
    .name = "link-entry-disagrees",
    .severity = Severity::warning,
    .summary = "An entry of `link` names two links.",
    .why = "MARS and Phobos select the link by `name`, MARS 2 by `link`: the entry changes "
           "another link in each.",
    .remedy = "Write the same name under both keys.",
    .sources = "MARS smurf.cpp:353-365; envire_smurf_loader Model.cpp:216-230.",
    .check_model = check};

}  // namespace smurf::rules
