// SPDX-License-Identifier: BSD-3-Clause
#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  NameTable visuals, collisions;
  std::vector<Span> places;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (!use.name || use.name->empty()) return;
    auto& seen = use.role == GeometryRole::visual ? visuals : collisions;
    const auto first = seen.add(*use.name, static_cast<std::uint32_t>(places.size()));
    places.push_back(use.name.span);
    if (!first) return;
    Diagnostic& diagnostic =
        findings.report(use.name.span, "a second " + std::string(to_string(use.role)) +
                                           " of the name " + quoted(*use.name));
    diagnostic.labels.push_back({places[*first], "the first"});
  });
}

}  // namespace

extern constinit const Rule sml1304_duplicate_visual_or_collision_name{
    .id = "SML1304",
    .name = "duplicate-visual-or-collision-name",
    .severity = Severity::warning,
    .summary = "Two visuals, or two collisions, have one name.",
    .why = "MARS finds them by name only, so annotations reach the last one; MuJoCo leaves the "
           "second geometry without name, Drake and DART rename it.",
    .remedy = "Give each a name of its own.",
    .sources = "MARS smurf.cpp:405-449, 706, 779; MuJoCo 3.14 (xml_urdf.cc:326-359) and DART 6.12, "
               "executed.",
    .check_model = check};

}  // namespace smurf::rules
