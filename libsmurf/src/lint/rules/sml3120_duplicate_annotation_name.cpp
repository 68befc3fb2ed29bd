// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3120_duplicate_annotation_name_file {
namespace {

constexpr std::string_view kLeads = "in MARS, the name refers to the last one";
constexpr std::string_view kReplaces = "readers disagree on which of the two they use";

template <class Entries>
void check_entries(const Entries& entries, std::string_view kind, std::string_view note,
                   Findings& findings) {
  NameTable names;
  names.reserve(entries.size());
  for (std::uint32_t i = 0; i < entries.size(); ++i) {
    const auto& entry = entries[i];
    if (!entry.name || entry.name->empty()) continue;
    const auto first = names.add(*entry.name, i);
    if (!first) continue;
    Diagnostic& diagnostic = findings.report(
        entry.name.span, "there is another " + std::string(kind) + " " + quoted(*entry.name));
    diagnostic.label(entries[*first].name.span, "the first one");
    diagnostic.note(std::string(note));
  }
}

void check(const LinkedModel& model, Findings& findings) {
  const Annotations& all = model.annotations;
  check_entries(all.motors, "motor", kLeads, findings);
  check_entries(all.sensors, "sensor", kLeads, findings);
  check_entries(all.controllers, "controller", kLeads, findings);
  check_entries(all.poses, "joint pose", kLeads, findings);
  check_entries(all.materials, "material entry", kReplaces, findings);
  check_entries(all.collisions, "collision entry", kReplaces, findings);
  check_entries(all.visuals, "visual entry", kReplaces, findings);
  check_entries(all.links, "link entry", kReplaces, findings);
  check_entries(all.joints, "joint entry", kReplaces, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "creates both, but a name refers to the last one only: controllers, poses and mimicking "
     "motors never reach the first; entries that change the URDF are applied one after the other",
     "MARS smurf.cpp:262, 326"},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun, at("motors")},
    {&readers::phobos, Effect::changes,
     "keeps the last sensor and both poses, and applies other entries one after the other", kRun},
};

}  // namespace

extern constinit const Rule sml3120_duplicate_annotation_name{
    .id = "SML3120",
    .name = "duplicate-annotation-name",
    .severity = Severity::warning,
    .summary = "Two entries of a section have the same name.",
    .remedy = "Rename one of them, or merge the two entries.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3120_duplicate_annotation_name_file
