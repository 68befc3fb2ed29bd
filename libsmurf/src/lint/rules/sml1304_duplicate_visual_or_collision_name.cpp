// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1304_duplicate_visual_or_collision_name_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  NameTable visuals, collisions;
  if (model.robot) {  // of robots as they mostly are
    visuals.reserve(model.robot->links.size());
    collisions.reserve(model.robot->links.size());
  }
  std::vector<Span> places;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (!use.name || use.name->empty()) return;
    auto& seen = use.role == GeometryRole::visual ? visuals : collisions;
    const auto first = seen.add(*use.name, static_cast<std::uint32_t>(places.size()));
    places.push_back(use.name.span);
    if (!first) return;
    Diagnostic& diagnostic =
        findings.report(use.name.span, "a second " + std::string(to_string(use.role)) +
                                           " is named " + quoted(*use.name));
    diagnostic.label(places[*first], "the first");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "finds them by name only, so annotations apply to the last one",
     "MARS smurf.cpp:405-449, 706, 779"},
    {&readers::dart, Effect::ignores, "renames the second one", kRun},
    {&readers::mujoco, Effect::changes, "leaves the second geometry without a name",
     "MuJoCo xml_urdf.cc:326-359, run"},
    {&readers::drake, Effect::ignores, "renames the second one", kRun},
};

}  // namespace

extern constinit const Rule sml1304_duplicate_visual_or_collision_name{
    .id = "SML1304",
    .name = "duplicate-visual-or-collision-name",
    .severity = Severity::warning,
    .summary = "Two visuals, or two collisions, have the same name.",
    .remedy = "Give each a different name.",
    .check_model = check,
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1304_duplicate_visual_or_collision_name_file
