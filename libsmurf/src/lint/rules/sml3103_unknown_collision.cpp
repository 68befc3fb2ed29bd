// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const CollisionAnnotation& entry : model.annotations.collisions) {
    if (!entry.name || creates_collision(model, entry)) continue;
    // Without its link there is no collision either; the link is reported.
    if (entry.link && !model.link_names.contains(*entry.link)) continue;
    check_reference(model, NameKind::collision, *entry.name, entry.name.span,
                    "this collision entry", findings);
  }
  for (const LinkAnnotation& link : model.annotations.links) {
    for (const Spanned<std::string>& name : texts_at(mapping_of(model, link), "collisions")) {
      check_reference(model, NameKind::collision, name.value, name.span, subject("link", link),
                      findings);
    }
  }
  for (const Sensor& sensor : model.annotations.sensors) {
    const Subject who = subject("sensor", sensor);
    check_references(model, NameKind::collision, sensor.collisions, who, findings);
    if (sensor.type && sensor_target(*sensor.type) == NameKind::collision) {
      check_references(model, NameKind::collision, sensor.id, who, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "the bitmask and contact parameters have no effect, and a contact sensor has no targets",
     "MARS smurf.cpp:302-305, 427-449"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run",
     "/sensors/"},
};

}  // namespace

extern constinit const Rule sml3103_unknown_collision{
    .id = "SML3103",
    .name = "unknown-collision",
    .severity = Severity::error,
    .summary = "An annotation names a collision that the URDF does not have.",
    .remedy = "Correct the name; collisions without name in the URDF cannot be referred to.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
