// SPDX-License-Identifier: BSD-3-Clause
// An SRDF as written: groups, poses, end effectors and pairs of links, each with its place.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "smurf/source.hpp"
#include "smurf/xml.hpp"

namespace smurf::srdf {

// Texts are without the blanks around them, as srdfdom reads them.
using Text = Field<std::string>;

/// A child of a group.
struct Member {
  enum class Kind : std::uint8_t { link, joint, chain, group };
  Kind kind = Kind::link;
  xml::ElementId element = xml::kNoElement;
  Text name;       ///< of a link, joint or group
  Text base, tip;  ///< of a chain
};

/// A `group`, a set of links, joints, chains and other groups.
struct Group {
  xml::ElementId element = xml::kNoElement;
  Text name;
  std::vector<Member> members;
};

/// A joint of a group state and its values, separated by blanks.
struct StateJoint {
  xml::ElementId element = xml::kNoElement;
  Text name, value;
};

/// A `group_state`: positions of the joints of a group.
struct GroupState {
  xml::ElementId element = xml::kNoElement;
  Text name, group;
  std::vector<StateJoint> joints;
};

/// An `end_effector`: a group that is attached to a link of another group.
struct EndEffector {
  xml::ElementId element = xml::kNoElement;
  Text name, group, parent_link, parent_group;
};

/// A `virtual_joint` between the world and the root link.
struct VirtualJoint {
  xml::ElementId element = xml::kNoElement;
  Text name, type, parent_frame, child_link;
};

/// `disable_collisions` or `enable_collisions`.
struct LinkPair {
  xml::ElementId element = xml::kNoElement;
  bool is_enabled = false;
  Text link1, link2, reason;
};

/// A `passive_joint`, which no motor moves.
struct PassiveJoint {
  xml::ElementId element = xml::kNoElement;
  Text name;
};

/// A `joint_property` or one of its older forms: a named value of a joint.
struct JointProperty {
  xml::ElementId element = xml::kNoElement;
  Text joint, property, value;
};

/// `disable_default_collisions` or `link_sphere_approximation`.
struct LinkEntry {
  xml::ElementId element = xml::kNoElement;
  Text link;
};

/// All in the order of the file.
struct Description {
  xml::Document document;
  Text name;
  std::vector<VirtualJoint> virtual_joints;
  std::vector<Group> groups;
  std::vector<GroupState> states;
  std::vector<EndEffector> end_effectors;
  std::vector<LinkPair> pairs;
  std::vector<PassiveJoint> passive_joints;
  std::vector<JointProperty> properties;
  std::vector<LinkEntry> links;
  /// The first group of each name. The names point into `groups`.
  std::unordered_map<std::string_view, std::size_t> group_numbers;

  const Group* find_group(std::string_view wanted) const;
  const VirtualJoint* find_virtual_joint(std::string_view wanted) const;
};

}  // namespace smurf::srdf
