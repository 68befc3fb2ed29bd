// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const MaterialAnnotation& entry : model.annotations.materials) {
    if (!entry.name) continue;
    check_reference(model, NameKind::material, *entry.name, entry.name.span, "this material entry",
                    findings);
  }
  for (const VisualAnnotation& entry : model.annotations.visuals) {
    if (!entry.material_name) continue;
    check_reference(model, NameKind::material, *entry.material_name, entry.material_name.span,
                    subject("visual entry", entry), findings);
  }
  for (const NodeAnnotation& entry : model.annotations.nodes) {
    if (!entry.material_name) continue;
    check_reference(model, NameKind::material, *entry.material_name, entry.material_name.span,
                    subject("node", entry), findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::ignores, "ignores the entry", "MARS smurf.cpp:333-352"},
    {&readers::phobos, Effect::ignores, "ignores the entry", "Phobos smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml3104_unknown_material{
    .id = "SML3104",
    .name = "unknown-material",
    .severity = Severity::error,
    .summary = "An annotation names a material that the URDF does not have.",
    .remedy = "Correct the name, or define the material in the URDF.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
