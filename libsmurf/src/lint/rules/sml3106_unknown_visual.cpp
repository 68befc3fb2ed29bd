// SPDX-License-Identifier: BSD-3-Clause
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const VisualAnnotation& entry : model.annotations.visuals) {
    if (!entry.name) continue;
    check_reference(model, NameKind::visual, *entry.name, entry.name.span, "this visual entry",
                    findings);
  }
  for (const LinkAnnotation& link : model.annotations.links) {
    for (const Spanned<std::string>& name : texts_at(mapping_of(model, link), "visuals")) {
      check_reference(model, NameKind::visual, name.value, name.span, subject("link", link),
                      findings);
    }
  }
}

}  // namespace

extern constinit const Rule sml3106_unknown_visual{
    .id = "SML3106",
    .name = "unknown-visual",
    .severity = Severity::error,
    .summary = "An annotation names a visual that the URDF does not have.",
    .why = "MARS prints a message and ignores the entry.",
    .remedy = "Correct the name; visuals without name cannot be referred to.",
    .sources = "MARS smurf.cpp:404-426.",
    .check_model = check};

}  // namespace smurf::rules
