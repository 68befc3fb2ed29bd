// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    const std::string who = subject("sensor", sensor);
    if (sensor.link) {
      check_reference(model, NameKind::link, *sensor.link, sensor.link.span, who, findings);
    }
    check_references(model, NameKind::link, sensor.links, who, findings);
  }
  for (const CollisionAnnotation& entry : model.annotations.collisions) {
    if (!entry.link) continue;
    check_reference(model, NameKind::link, *entry.link, entry.link.span,
                    subject("collision entry", entry), findings);
  }
  for (const LinkAnnotation& entry : model.annotations.links) {
    const Field<std::string>& name = entry.name.written ? entry.name : entry.link;
    if (!name) continue;
    check_reference(model, NameKind::link, *name, name.span, "this link entry", findings);
  }
  for (const NodeAnnotation& entry : model.annotations.nodes) {
    if (!entry.parent) continue;
    check_reference(model, NameKind::link, *entry.parent, entry.parent.span, subject("node", entry),
                    findings);
  }
}

}  // namespace

extern constinit const Rule sml3102_unknown_link{
    .id = "SML3102",
    .name = "unknown-link",
    .severity = Severity::error,
    .summary = "An annotation names a link that the URDF does not have.",
    .why = "MARS looks names up in a map that answers 0 for unknown ones: a sensor is attached to "
           "nothing (Joint6DOF dereferences a null pointer), the entry has no effect.",
    .remedy = "Correct the name.",
    .sources = "MARS smurf.cpp:272-332, 353-390.",
    .check_model = check};

}  // namespace smurf::rules
