// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3103_unknown_collision_file {
namespace {

/// If the link is unknown, so is the collision; only the link is reported.
bool is_on_unknown_link(const LinkedModel& model, const AnnotationPlace& place) {
  if (place.section != "collision" || place.key != "name") return false;
  const yaml::View link = place.entry.find("link");
  return link && link.is_scalar() && !model.link_names.contains(link.text());
}

void check(const LinkedModel& model, Findings& findings) {
  report_unknown(model, NameKind::collision, findings,
                 [&](const AnnotationPlace& place) { return is_on_unknown_link(model, place); });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "the bitmask and contact parameters have no effect, and a contact sensor has no targets",
     "MARS smurf.cpp:302-305, 427-449"},
    {&readers::phobos, Effect::takes, "expects the names of links", kRun, at("sensors")},
    {&readers::phobos, Effect::refuses, "stops with an exception", kRun},
};

}  // namespace

extern constinit const Rule sml3103_unknown_collision{
    .id = "SML3103",
    .name = "unknown-collision",
    .severity = Severity::error,
    .summary = "An annotation names a collision that the URDF does not have.",
    .remedy = "Correct the name; an annotation cannot name a collision that has no name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3103_unknown_collision_file
