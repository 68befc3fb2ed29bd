// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:427-449; rock-cpp/smurf Robot.cpp:53-83; mars_ode_collision
// Object.cpp:56-79; Phobos representation.py.
#include "ast/sections.hpp"

namespace smurf::sections::collision_file {
namespace {

using enum ValueType;

/// Phobos 2 makes collisions that the URDF does not have from entries with a geometry.
Naming own_name(yaml::View entry) { return {NameKind::collision, bool(entry.find("geometry"))}; }

constexpr Key<CollisionAnnotation> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "Name of a collision of the URDF.",
      .required = true,
      .names_in = own_name},
     &CollisionAnnotation::name},
    {{.name = "link",
      .type = text,
      .doc = "Link of the collision; MARS 2 and rock-cpp/smurf match by it as well.",
      .read_by = "MARS 2, MARS with envire",
      .names = {NameKind::link}},
     &CollisionAnnotation::link},
    {{.name = "bitmask",
      .type = integer,
      .doc =
          "Two objects collide when their masks share a bit; ray sensors see bit 15 (32768). The "
          "default of rock-cpp/smurf is 0: no collisions.",
      .fallback = "65535"},
     &CollisionAnnotation::bitmask},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "geometry", .type = any, .doc = "Shape, written by Phobos 2.", .read_by = "Phobos 2"},
    {.name = "primitives",
     .type = any,
     .doc = "Replacement by simple shapes, Phobos 2.",
     .read_by = "Phobos 2"},
    {.name = "capsules",
     .type = list,
     .doc = "Written by Phobos 0.7, read by nobody.",
     .read_by = "nobody"},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<CollisionAnnotation>(kKeys, {kMoreKeys, node_keys()}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<CollisionAnnotation>(kKeys, {kMoreKeys, node_keys()}, "collision", entry, section,
                                 out.collisions, sink);
}

constexpr std::string_view kAliases[] = {"collisions"};

}  // namespace

constinit const SectionSpec collision{
    .name = "collision",
    .aliases = kAliases,
    .entry = "collision",
    .doc = "Contact parameters of URDF collisions.",
    .read_by =
        "MARS 1 (matches by name), MARS 2 and MARS with envire (match by name and link), Phobos 2; "
        "`collisions` is read by Phobos 2 only, which writes it",
    .filtered_keys = keys,
    .read = read,
    .list = list_of<&Annotations::collisions>()};

}  // namespace smurf::sections::collision_file
