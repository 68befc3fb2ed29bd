// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:366-390.
#include "ast/sections.hpp"

namespace smurf::sections::nodes_file {
namespace {

using enum ValueType;

/// An entry with a parent makes a new node.
Naming own_name(yaml::View entry) {
  if (entry.find("parent")) return defines(NameKind::node);
  return {kNodeKinds.without(NameKind::node)};
}

constexpr Key<NodeAnnotation> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "A link, inertial_LINK, a collision or a visual; any other name makes a new node.",
      .required = true,
      .names_in = own_name},
     &NodeAnnotation::name},
    {{.name = "parent",
      .type = text,
      .doc = "Link that a new node is placed relative to.",
      .names = {NameKind::link}},
     &NodeAnnotation::parent},
    {{.name = "vizLink",
      .type = text,
      .doc = "Link that a new node is shown with.",
      .names = {NameKind::link}},
     &NodeAnnotation::viz_link},
    {{.name = "materialName",
      .type = text,
      .doc = "Name of the material.",
      .names = {NameKind::material}},
     &NodeAnnotation::material_name},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<NodeAnnotation>(kKeys, {node_keys()}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<NodeAnnotation>(kKeys, {node_keys()}, "node", entry, section, out.nodes, sink);
}

}  // namespace

constinit const SectionSpec nodes{.name = "nodes",
                                  .entry = "node",
                                  .doc = "Changes to nodes of MARS, and new nodes.",
                                  .read_by = "MARS 1; Phobos 2 stops with an error at this section",
                                  .filtered_keys = keys,
                                  .read = read,
                                  .list = list_of<&Annotations::nodes>()};

}  // namespace smurf::sections::nodes_file
