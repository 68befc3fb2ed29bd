// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:366-390.
#include "ast/sections.hpp"

namespace smurf::sections {
namespace {

using enum ValueType;

constexpr Key<NodeAnnotation> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "A link, inertial_LINK, a collision or a visual; any other name makes a new node.",
      .required = true},
     &NodeAnnotation::name},
    {{.name = "parent", .type = text, .doc = "Link that a new node is placed relative to."},
     &NodeAnnotation::parent},
    {{.name = "vizLink", .type = text, .doc = "Link that a new node is shown with."},
     &NodeAnnotation::viz_link},
    {{.name = "materialName", .type = text, .doc = "Name of the material."},
     &NodeAnnotation::material_name},
};

std::vector<const KeySpec*> keys() { return specs_of<NodeAnnotation>(kKeys, {node_keys()}); }

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<NodeAnnotation>(kKeys, {node_keys()}, "node", entry, section, out.nodes, sink);
}

}  // namespace

constinit const SectionSpec nodes{.name = "nodes",
                                  .entry = "node",
                                  .doc = "Changes to nodes of MARS, and new nodes.",
                                  .keys = keys,
                                  .read = read};

}  // namespace smurf::sections
