// SPDX-License-Identifier: BSD-3-Clause
// Sources: Phobos hyrodyn.py, robot.py:352-360; HyRoDyn files of ARC-OPT/wbc.
#include "ast/sections.hpp"

namespace smurf::sections::submechanisms_file {
namespace {

using enum ValueType;

constexpr Key<Submechanism> kKeys[] = {
    {{.name = "name", .type = text, .doc = "Kind of mechanism; may repeat.", .required = true},
     &Submechanism::name},
    {{.name = "contextual_name",
      .type = text,
      .doc = "Name of the mechanism in the robot.",
      .required = true},
     &Submechanism::contextual_name},
    {{.name = "type",
      .type = text,
      .doc = "Structure of the mechanism: serial, R, RRR, 2SPU+1U, ...",
      .fallback = "\"numerical\""},
     &Submechanism::type},
    {{.name = "jointnames",
      .type = name_list,
      .doc = "All joints, fixed ones included.",
      .names = may_name(NameKind::joint)},
     &Submechanism::joint_names},
    {{.name = "jointnames_spanningtree",
      .type = name_list,
      .doc = "Movable joints.",
      .names = may_name(NameKind::joint)},
     &Submechanism::joint_names_spanning_tree},
    {{.name = "jointnames_active",
      .type = name_list,
      .doc = "Joints with a motor.",
      .names = may_name(NameKind::joint)},
     &Submechanism::joint_names_active},
    {{.name = "jointnames_independent",
      .type = name_list,
      .doc = "Joints whose positions determine all others.",
      .names = may_name(NameKind::joint)},
     &Submechanism::joint_names_independent},
};

constexpr KeySpec kAxisKeys[] = {
    {.name = "name", .type = text, .doc = "Name of the axis."},
    {.name = "axis", .type = any, .doc = "Direction of the axis."},
};

constexpr KeySpec kLoopKeys[] = {
    {.name = "cut_joint",
     .type = text,
     .doc = "Joint where the loop is cut.",
     .names = may_name(NameKind::joint)},
    {.name = "predecessor_body",
     .type = text,
     .doc = "Link before the cut.",
     .names = may_name(NameKind::link)},
    {.name = "successor_body",
     .type = text,
     .doc = "Link after the cut.",
     .names = may_name(NameKind::link)},
    {.name = "constraint_axes",
     .type = list,
     .doc = "Axes of the cut joint.",
     .members = kAxisKeys},
};

constexpr KeySpec kLeaderKeys[] = {
    {.name = "joint",
     .type = text,
     .doc = "Joint that this one follows.",
     .names = may_name(NameKind::joint)},
    {.name = "multiplier",
     .type = number,
     .doc = "Factor on the position of that joint.",
     .fallback = "1"},
    {.name = "offset",
     .type = number,
     .doc = "Offset that is added to the scaled position.",
     .unit = "rad or m",
     .fallback = "0"},
};

constexpr KeySpec kDependencyKeys[] = {
    {.name = "name",
     .type = text,
     .doc = "Joint that follows others.",
     .names = may_name(NameKind::joint)},
    {.name = "depends_on",
     .type = list,
     .doc = "Joints that it follows: their names, or for Phobos mappings.",
     .members = kLeaderKeys,
     .names = may_name(NameKind::joint)},
};

constexpr KeySpec kMoreKeys[] = {
    {.name = "loop_constraints", .type = list, .doc = "Closed loops.", .members = kLoopKeys},
    {.name = "multi_joint_dependencies",
     .type = list,
     .doc = "Joints that follow others.",
     .members = kDependencyKeys},
    {.name = "file_path", .type = text, .doc = "URDF of the mechanism alone."},
    {.name = "auto_gen",
     .type = boolean,
     .doc = "Phobos computes the value from the joints and does not read it.",
     .fallback = "false"},
};

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<Submechanism>(kKeys, {kMoreKeys}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<Submechanism>(kKeys, {kMoreKeys}, "submechanism", entry, section, out.submechanisms,
                          sink);
}

}  // namespace

constinit const SectionSpec submechanisms{.name = "submechanisms",
                                          .entry = "submechanism",
                                          .doc = "Mechanisms of the robot, for Phobos and HyRoDyn.",
                                          .read_by = "Phobos 2",
                                          .filtered_keys = keys,
                                          .read = read,
                                          .list = list_of<&Annotations::submechanisms>()};

}  // namespace smurf::sections::submechanisms_file
