// SPDX-License-Identifier: BSD-3-Clause
#include <unordered_set>

#include "base/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules {
namespace {

void check_link(const LinkedModel& model, const Field<std::string>& name, const Subject& who,
                Findings& findings) {
  if (name) check_reference(model, NameKind::link, *name, name.span, who, findings);
}

constexpr std::string_view kInertial = "inertial_";

/// The names of nodes in MARS: links, `inertial_LINK`, collisions, visuals, and entries of `nodes`.
class NodeNames {
 public:
  explicit NodeNames(const LinkedModel& model) : model_(model) {
    for (const NodeAnnotation& node : model.annotations.nodes) {
      if (node.name && node.parent.written) entries_.insert(*node.name);
    }
  }

  bool has(std::string_view name) const {
    if (model_.link_names.contains(name) || model_.collision_names.contains(name) ||
        model_.visual_names.contains(name) || entries_.contains(name)) {
      return true;
    }
    return name.starts_with(kInertial) && model_.link_names.contains(name.substr(kInertial.size()));
  }

 private:
  const LinkedModel& model_;
  std::unordered_set<std::string_view> entries_;
};

/// Sensors of nodes take the names of collisions and visuals, too.
void check_nodes(const LinkedModel& model, const NodeNames& nodes, const Field<NameList>& list,
                 const Subject& who, Findings& findings) {
  if (!list) return;
  for (const Spanned<std::string>& name : *list) {
    if (nodes.has(name.value)) continue;
    check_reference(model, NameKind::link, name.value, name.span, who, findings);
  }
}

/// An entry for the inertia of a link that is not there makes a new node.
void check_inertial(const LinkedModel& model, const NodeNames& nodes, const NodeAnnotation& entry,
                    Findings& findings) {
  if (!entry.name || !entry.name->starts_with(kInertial) || entry.parent.written) return;
  if (nodes.has(*entry.name)) return;
  Span place = within_quotes(model, entry.name.span);
  place.begin += static_cast<std::uint32_t>(kInertial.size());
  check_reference(model, NameKind::link, entry.name->substr(kInertial.size()), place,
                  "this node entry", findings);
}

void check(const LinkedModel& model, Findings& findings) {
  const NodeNames nodes(model);
  for (const Sensor& sensor : model.annotations.sensors) {
    const Subject who = subject("sensor", sensor);
    if (sensor.link) {
      check_reference(model, NameKind::link, *sensor.link, sensor.link.span, who, findings);
    }
    check_references(model, NameKind::link, sensor.links, who, findings);
    if (sensor.type && sensor_target(*sensor.type) == NameKind::link) {
      check_nodes(model, nodes, sensor.id, who, findings);
    }
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
    check_inertial(model, nodes, entry, findings);
    check_link(model, entry.parent, subject("node", entry), findings);
    check_link(model, entry.viz_link, subject("node", entry), findings);
  }
  for (const VisualAnnotation& entry : model.annotations.visuals) {
    check_link(model, entry.link, subject("visual entry", entry), findings);
  }
  for (const JointAnnotation& entry : model.annotations.joints) {
    const Subject who = subject("joint", entry);
    check_link(model, entry.parent, who, findings);
    check_link(model, entry.child, who, findings);
    const auto body = text_at(mapping_of(model, entry), "gearbox_reference_body");
    if (body) check_reference(model, NameKind::link, body->value, body->span, who, findings);
  }
  for (const Interface& entry : model.annotations.interfaces) {
    check_link(model, entry.parent, subject("interface", entry), findings);
  }
  for (const Light& light : model.annotations.lights) {
    // The node may belong to another robot of the scene.
    if (!light.node_name || nodes.has(*light.node_name)) continue;
    if (!is_slip(model, NameKind::link, *light.node_name)) continue;
    check_link(model, light.node_name, subject("light", light), findings);
  }
  for (const Submodel& entry : model.annotations.submodels) {
    check_link(model, entry.start, subject("submodel", entry), findings);
    check_references(model, NameKind::link, entry.stop, subject("submodel", entry), findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "dereferences a null pointer for a Joint6DOF",
     "MARS smurf.cpp:277-283", "/sensors/"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run",
     "/sensors/"},
};

}  // namespace

extern constinit const Rule sml3102_unknown_link{
    .id = "SML3102",
    .name = "unknown-link",
    .severity = Severity::error,
    .summary = "An annotation names a link that the URDF does not have.",
    .remedy = "Correct the name.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
