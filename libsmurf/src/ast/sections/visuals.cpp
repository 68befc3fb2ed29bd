// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:404-426.
#include "ast/sections.hpp"

namespace smurf::sections::visuals_file {
namespace {

using enum ValueType;

constexpr Key<VisualAnnotation> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "Name of a visual of the URDF.",
      .required = true,
      .names = {NameKind::visual}},
     &VisualAnnotation::name},
    {{.name = "link", .type = text, .doc = "Link of the visual.", .names = {NameKind::link}},
     &VisualAnnotation::link},
    {{.name = "materialName",
      .type = text,
      .doc = "Name of the material that replaces the URDF's.",
      .names = {NameKind::material}},
     &VisualAnnotation::material_name},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "geometry", .type = any, .doc = "Shape, written by Phobos 2.", .read_by = "Phobos 2"},
    {.name = "lod",
     .type = any,
     .doc = "Levels of detail, written by Phobos up to 1.0.",
     .read_by = "nobody"},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<VisualAnnotation>(kKeys, {kMoreKeys, node_keys()}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<VisualAnnotation>(kKeys, {kMoreKeys, node_keys()}, "visual", entry, section,
                              out.visuals, sink);
}

constexpr std::string_view kAliases[] = {"visual"};

}  // namespace

constinit const SectionSpec visuals{.name = "visuals",
                                    .aliases = kAliases,
                                    .entry = "visual",
                                    .doc = "Changes to how URDF visuals are shown.",
                                    .read_by = "MARS 1, Phobos 2",
                                    .filtered_keys = keys,
                                    .read = read,
                                    .list = list_of<&Annotations::visuals>()};

}  // namespace smurf::sections::visuals_file
