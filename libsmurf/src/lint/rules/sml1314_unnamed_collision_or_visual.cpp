// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1314_unnamed_collision_or_visual_file {
namespace {

/// One finding each for visuals and collisions: an exporter names all of them, or none.
void check_role(const LinkedModel& model, GeometryRole role, Findings& findings) {
  std::size_t count = 0;
  Span first;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (use.role != role || use.name.written) return;
    if (count++ == 0) first = tag_name(model, use.element);
  });
  if (count == 0) return;
  const std::string what(to_string(role));
  Diagnostic& diagnostic = findings.report(
      first, "this " + what + " has no name, and the annotations name " + what + "s");
  diagnostic.note("MARS names each of them `" + what + "_`");
  if (count > 1) {
    diagnostic.note(std::to_string(count - 1) + " more in this file");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || !model.robot) return;
  if (!model.annotations.visuals.empty()) check_role(model, GeometryRole::visual, findings);
  if (!model.annotations.collisions.empty()) check_role(model, GeometryRole::collision, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "names every unnamed one `collision_` or `visual_`, so annotations cannot refer to it; finds "
     "only the last one",
     "MARS smurf.cpp:405-449, 706, 779"},
};

}  // namespace

extern constinit const Rule sml1314_unnamed_collision_or_visual{
    .id = "SML1314",
    .name = "unnamed-collision-or-visual",
    .severity = Severity::warning,
    .summary = "A collision or visual has no name, although annotations refer to collisions or "
               "visuals by name.",
    .remedy = "Name it; names such as LINK_collision_1 are common.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1314_unnamed_collision_or_visual_file
