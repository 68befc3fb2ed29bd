// SPDX-License-Identifier: BSD-3-Clause
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1712_material_in_collision_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  Span first;
  std::size_t count = 0;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.role != GeometryRole::collision) return;
    const xml::View material = xml::View(model.robot->document, use.element).child("material");
    if (!material) return;
    if (first.empty()) first = material.name_span();
    ++count;
  });
  if (count == 0) return;
  Diagnostic& diagnostic =
      findings.report(first, "the material of a collision is ignored by every reader");
  if (count > 1) {
    diagnostic.note("this applies to " + std::to_string(count) + " collisions");
  }
}

}  // namespace

extern constinit const Rule sml1712_material_in_collision{
    .id = "SML1712",
    .name = "material-in-collision",
    .severity = Severity::info,
    .summary = "A collision has a material.",
    .why = "Every reader ignores it.",
    .remedy = "Delete it, or move it to the visual.",
    .sources = "urdfdom link.cpp; MuJoCo xml_urdf.cc.",
    .check_model = check};

}  // namespace smurf::rules::sml1712_material_in_collision_file
