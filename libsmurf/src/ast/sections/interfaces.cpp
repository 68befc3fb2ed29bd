// SPDX-License-Identifier: BSD-3-Clause
// Sources: Phobos representation.py:2289-2326.
#include "ast/sections.hpp"

namespace smurf::sections::interfaces_file {
namespace {

using enum ValueType;

constexpr Key<Interface> kKeys[] = {
    {{.name = "name", .type = text, .doc = "Name of the interface.", .required = true},
     &Interface::name},
    {{.name = "parent",
      .type = text,
      .doc = "Link that carries the interface.",
      .required = true,
      .names = {NameKind::link}},
     &Interface::parent},
    {{.name = "type",
      .type = text,
      .doc = "Type of the interface; interfaces of one type can be "
             "joined."},
     &Interface::type},
    {{.name = "direction", .type = text, .doc = "Side of the joint: inward, outward, ..."},
     &Interface::direction},
    {{.name = "position",
      .type = vector3_list,
      .doc = "Position in the frame of the link.",
      .unit = "m",
      .fallback = "[0, 0, 0]"},
     &Interface::position},
    {{.name = "rotation",
      .type = vector3_list,
      .doc = "Roll, pitch, yaw in the frame of the link, in radians.",
      .unit = "rad",
      .fallback = "[0, 0, 0]"},
     &Interface::rotation},
};

std::vector<const KeySpec*> keys(KeyFilter takes) { return specs_of<Interface>(kKeys, {}, takes); }

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Interface>(kKeys, {}, "interface", entry, section, out.interfaces, sink);
}

}  // namespace

constinit const SectionSpec interfaces{.name = "interfaces",
                                       .entry = "interface",
                                       .doc = "Places where models can be joined, for Phobos.",
                                       .read_by = "Phobos 2",
                                       .filtered_keys = keys,
                                       .read = read,
                                       .list = list_of<&Annotations::interfaces>()};

}  // namespace smurf::sections::interfaces_file
