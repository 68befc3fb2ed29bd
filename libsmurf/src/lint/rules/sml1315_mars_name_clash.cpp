// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "lint/geometry_queries.hpp"

namespace smurf::rules {
namespace {

struct Seen {
  std::string what;
  Span place;
};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.has_main || !model.robot) return;
  std::map<std::string, Seen, std::less<>> seen;
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.name) return;
    seen.emplace(*link.name, Seen{"link", link.name.span});
    if (link.inertial) seen.emplace("inertial_" + *link.name, Seen{"inertial", link.name.span});
  });
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (!use.name || use.name->empty()) return;
    const std::string what(to_string(use.role));
    const auto [first, is_new] = seen.emplace(*use.name, Seen{what, use.name.span});
    if (is_new || first->second.what == what) return;  // of one kind: a rule of its own
    Diagnostic& diagnostic =
        findings.report(use.name.span, "the " + what + " " + quoted(*use.name) +
                                           " has the name of a " + first->second.what);
    diagnostic.labels.push_back({first->second.place, "the " + first->second.what});
    diagnostic.notes.push_back("MARS keeps both in one table, and the last one in it");
  });
}

}  // namespace

extern constinit const Rule sml1315_mars_name_clash{
    .id = "SML1315",
    .name = "mars-name-clash",
    .severity = Severity::warning,
    .summary = "Two parts of a SMURF model that MARS keeps in one table have the same name.",
    .why = "MARS makes nodes of links, inertials (`inertial_LINK`), visuals and collisions and "
           "finds all of them in one table: the last one takes the name, and what refers to the "
           "other reaches the wrong node.",
    .remedy = "Rename one of them, e.g. with the ending `_visual` or `_collision`.",
    .sources = "MARS smurf.cpp:619, 661, 715, 788.",
    .check_model = check};

}  // namespace smurf::rules
