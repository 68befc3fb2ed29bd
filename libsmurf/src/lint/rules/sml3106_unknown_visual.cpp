// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
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

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "prints a message and ignores the entry",
     "MARS smurf.cpp:404-426"},
};

}  // namespace

extern constinit const Rule sml3106_unknown_visual{
    .id = "SML3106",
    .name = "unknown-visual",
    .severity = Severity::error,
    .summary = "An annotation names a visual that the URDF does not have.",
    .remedy = "Correct the name; visuals without name cannot be referred to.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
