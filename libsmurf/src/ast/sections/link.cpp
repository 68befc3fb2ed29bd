// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS smurf.cpp:353-365; envire_smurf_loader Model.cpp:216-230; Phobos
// representation.py:1764.
#include "ast/sections.hpp"

namespace smurf::sections::link_file {
namespace {

using enum ValueType;

constexpr Key<LinkAnnotation> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "Name of a link of the URDF, for MARS and Phobos.",
      .read_by = "MARS 1, Phobos 2",
      .names = {NameKind::link}},
     &LinkAnnotation::name},
    {{.name = "link",
      .type = text,
      .doc = "The name of the link again; MARS 2 stops at an entry without this key.",
      .read_by = "MARS 2",
      .names = {NameKind::link}},
     &LinkAnnotation::link},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "visuals",
     .type = name_list,
     .doc = "Visuals of the link, written by Phobos 2.",
     .read_by = "Phobos 2",
     .names = {NameKind::visual}},
    {.name = "collisions",
     .type = name_list,
     .doc = "Collisions of the link, written by Phobos 2.",
     .read_by = "Phobos 2",
     .names = {NameKind::collision}},
    {.name = "is_human",
     .type = boolean,
     .doc = "The link is part of a human (Phobos 2).",
     .fallback = "false",
     .read_by = "Phobos 2"},
    {.name = "anchor",
     .type = text,
     .doc = "On the root link, `world` fixes the model to the world unless the scene sets an "
            "anchor (Phobos)."},
    {.name = "keep_inertia",
     .type = boolean,
     .doc =
         "The inertia of 1 kg m^2 is meant: smurfs-flatten does not take it for a placeholder, in "
         "whose place it computes that of the shapes. Links of SDF have it where none is written.",
     .fallback = "false",
     .read_by = "nobody"},
    {.name = "kccd_hull",
     .type = any,
     .doc = "Hull for collision detection by KCCD (Phobos 2).",
     .read_by = "Phobos 2"},
    {.name = "origin", .type = any, .doc = "Pose of the link (Phobos 2).", .read_by = "Phobos 2"},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<LinkAnnotation>(kKeys, {kMoreKeys, node_keys()}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<LinkAnnotation>(kKeys, {kMoreKeys, node_keys()}, "link", entry, section, out.links,
                            sink);
}

constexpr std::string_view kAliases[] = {"links"};

}  // namespace

constinit const SectionSpec link{
    .name = "link",
    .aliases = kAliases,
    .entry = "link",
    .doc = "Changes to the frame nodes of URDF links.",
    .read_by =
        "MARS 1 (matches by the key `name`), MARS 2 (matches by the key `link`), Phobos 2; `links` is read by Phobos 2 only, which writes it",
    .filtered_keys = keys,
    .read = read,
    .list = list_of<&Annotations::links>()};

}  // namespace smurf::sections::link_file
