// SPDX-License-Identifier: BSD-3-Clause
// Sources: Phobos hyrodyn.py.
#include "ast/sections.hpp"

namespace smurf::sections::exoskeletons_file {
namespace {

using enum ValueType;

constexpr Key<Exoskeleton> kKeys[] = {
    {{.name = "name", .type = text, .doc = "Kind of exoskeleton; may repeat.", .required = true},
     &Exoskeleton::name},
    {{.name = "contextual_name",
      .type = text,
      .doc = "Name of the exoskeleton in the robot.",
      .required = true},
     &Exoskeleton::contextual_name},
    {{.name = "around", .type = text, .doc = "Part of the body that wears the exoskeleton."},
     &Exoskeleton::around},
    {{.name = "jointnames",
      .type = name_list,
      .doc = "All joints, fixed ones included.",
      .names = may_name(NameKind::joint)},
     &Exoskeleton::joint_names},
    {{.name = "jointnames_spanningtree",
      .type = name_list,
      .doc = "Movable joints.",
      .names = may_name(NameKind::joint)},
     &Exoskeleton::joint_names_spanning_tree},
    {{.name = "jointnames_dependent",
      .type = name_list,
      .doc = "Joints that the others follow.",
      .names = may_name(NameKind::joint)},
     &Exoskeleton::joint_names_dependent},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "auto_gen",
     .type = boolean,
     .doc = "Phobos computes the value from the joints and does not read it.",
     .fallback = "false"},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<Exoskeleton>(kKeys, {kMoreKeys}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Exoskeleton>(kKeys, {kMoreKeys}, "exoskeleton", entry, section, out.exoskeletons, sink);
}

}  // namespace

constinit const SectionSpec exoskeletons{
    .name = "exoskeletons",
    .entry = "exoskeleton",
    .doc = "Exoskeletons and the joints of the body they follow, for Phobos and HyRoDyn.",
    .read_by = "Phobos 2",
    .filtered_keys = keys,
    .read = read,
    .list = list_of<&Annotations::exoskeletons>()};

}  // namespace smurf::sections::exoskeletons_file
