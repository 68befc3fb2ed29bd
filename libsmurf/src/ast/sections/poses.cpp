// SPDX-License-Identifier: BSD-3-Clause
// Sources: MARS SimEntity.cpp:503-513; Phobos poses.py.
#include "ast/sections.hpp"
#include "base/numbers/quantity.hpp"

namespace smurf::sections::poses_file {
namespace {

using enum ValueType;

constexpr Key<JointPoseSet> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "Name that entities of a scene refer to by `pose`.",
      .required = true,
      .names = defines(NameKind::pose)},
     &JointPoseSet::name},
    {{.name = "joints",
      .type = number_map,
      .doc = "Position of each motor (MARS) or joint (Phobos): give both the same name.",
      .unit = "rad or m",
      .required = true,
      .names = {NameKind::motor | NameKind::joint}},
     {}},
};

/// Unusable positions, which the table has reported, have no value.
void read_joints(yaml::View joints, JointPoseSet& pose) {
  if (!joints || !joints.is_mapping()) return;
  for (const yaml::View joint : joints) {
    if (joint.is_null() || joint.is_repeated()) continue;
    const std::optional<double> number = joint.number();
    const bool is_usable = number && is_quantity(*number);
    pose.joints.push_back({{std::string(joint.key()), joint.key_span()},
                           {is_usable ? number : std::nullopt, joint.place()}});
  }
}

std::vector<const KeySpec*> keys(KeyFilter takes) {
  return specs_of<JointPoseSet>(kKeys, {}, takes);
}

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<JointPoseSet>(kKeys, {}, "joint pose set", entry, section, out.poses, sink);
  read_joints(entry.find("joints"), out.poses.back());
}

}  // namespace

constinit const SectionSpec poses{.name = "poses",
                                  .entry = "joint pose set",
                                  .doc = "Named joint positions.",
                                  .read_by = "MARS 1, MARS 2, Phobos 2",
                                  .filtered_keys = keys,
                                  .read = read,
                                  .list = list_of<&Annotations::poses>()};

}  // namespace smurf::sections::poses_file
