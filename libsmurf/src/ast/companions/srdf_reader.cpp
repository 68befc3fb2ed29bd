// SPDX-License-Identifier: BSD-3-Clause
// Source: srdfdom model.cpp (e23af6e).
#include "ast/companions/srdf_reader.hpp"

#include <algorithm>
#include <utility>

#include "base/text/words.hpp"

namespace smurf::srdf {
namespace {

constexpr std::string_view kName[] = {"name"};
constexpr std::string_view kVirtual[] = {"name", "type", "parent_frame", "child_link"};
constexpr std::string_view kChain[] = {"base_link", "tip_link"};
constexpr std::string_view kState[] = {"name", "group"};
constexpr std::string_view kValue[] = {"name", "value"};
constexpr std::string_view kEffector[] = {"name", "group", "parent_link"};
constexpr std::string_view kParentGroup[] = {"parent_group"};
constexpr std::string_view kPair[] = {"link1", "link2"};
constexpr std::string_view kReason[] = {"reason"};
constexpr std::string_view kLink[] = {"link"};
constexpr std::string_view kProperty[] = {"joint_name", "property_name", "value"};
constexpr std::string_view kSphere[] = {"center", "radius"};
constexpr std::string_view kVersion[] = {"version"};

constexpr ElementSpec kElements[] = {
    {"", "robot", kName, kVersion},
    {"robot", "virtual_joint", kVirtual},
    {"robot", "group", kName},
    {"group", "link", kName},
    {"group", "joint", kName},
    {"group", "chain", kChain},
    {"group", "group", kName},
    {"robot", "group_state", kState},
    {"group_state", "joint", kValue},
    {"robot", "end_effector", kEffector, kParentGroup},
    {"robot", "disable_collisions", kPair, kReason},
    {"robot", "enable_collisions", kPair, kReason},
    {"robot", "disable_default_collisions", kLink},
    {"robot", "passive_joint", kName},
    {"robot", "joint_property", kProperty},
    {"robot", "link_sphere_approximation", kLink},
    {"link_sphere_approximation", "sphere", kSphere},
};

Text text_of(xml::View element, std::string_view name) {
  const xml::Attribute* attribute = element.attribute(name);
  if (attribute == nullptr) return {};
  const std::string_view value = attribute->value();
  const std::string_view inner = trimmed(value);
  Span span = attribute->value_span();
  if (span.end - span.begin == value.size()) {  // otherwise, it contains entities
    span.begin +=
        static_cast<std::uint32_t>(inner.data() == nullptr ? 0 : inner.data() - value.data());
    span.end = span.begin + static_cast<std::uint32_t>(inner.size());
  }
  return {std::string(inner), span};
}

Group read_group(xml::View element) {
  Group group{element.id(), text_of(element, "name"), {}};
  for (const xml::View child : element) {
    Member member;
    member.element = child.id();
    if (child.name() == "chain") {
      member.kind = Member::Kind::chain;
      member.base = text_of(child, "base_link");
      member.tip = text_of(child, "tip_link");
    } else {
      if (child.name() == "joint") {
        member.kind = Member::Kind::joint;
      } else if (child.name() == "group") {
        member.kind = Member::Kind::group;
      } else if (child.name() != "link") {
        continue;
      }
      member.name = text_of(child, "name");
    }
    group.members.push_back(std::move(member));
  }
  return group;
}

GroupState read_state(xml::View element) {
  GroupState state{element.id(), text_of(element, "name"), text_of(element, "group"), {}};
  for (const xml::View child : element) {
    if (child.name() != "joint") continue;
    state.joints.push_back({child.id(), text_of(child, "name"), text_of(child, "value")});
  }
  return state;
}

void read_child(xml::View child, Description& to) {
  const auto text = [&](std::string_view name) { return text_of(child, name); };
  const std::string_view name = child.name();
  if (name == "virtual_joint") {
    to.virtual_joints.push_back(
        {child.id(), text("name"), text("type"), text("parent_frame"), text("child_link")});
  } else if (name == "group") {
    to.groups.push_back(read_group(child));
  } else if (name == "group_state") {
    to.states.push_back(read_state(child));
  } else if (name == "end_effector") {
    to.end_effectors.push_back(
        {child.id(), text("name"), text("group"), text("parent_link"), text("parent_group")});
  } else if (name == "disable_collisions" || name == "enable_collisions") {
    to.pairs.push_back(
        {child.id(), name == "enable_collisions", text("link1"), text("link2"), text("reason")});
  } else if (name == "passive_joint") {
    to.passive_joints.push_back({child.id(), text("name")});
  } else if (name == "joint_property") {
    to.properties.push_back({child.id(), text("joint_name"), text("property_name"), text("value")});
  } else if (name == "disable_default_collisions" || name == "link_sphere_approximation") {
    to.links.push_back({child.id(), text("link")});
  }
}

}  // namespace

std::span<const ElementSpec> all_element_specs() { return kElements; }

const ElementSpec* find_element_spec(std::string_view parent, std::string_view name) {
  const auto found = std::find_if(std::begin(kElements), std::end(kElements), [&](const auto& one) {
    return one.parent == parent && one.name == name;
  });
  return found == std::end(kElements) ? nullptr : &*found;
}

Description read(xml::Document&& document) {
  Description result;
  result.document = std::move(document);
  const xml::View root = result.document.view();
  if (!root || root.name() != "robot") return result;
  result.name = text_of(root, "name");
  for (const xml::View child : root) read_child(child, result);
  for (std::size_t i = 0; i < result.groups.size(); ++i) {
    if (const Text& name = result.groups[i].name) result.group_numbers.try_emplace(*name, i);
  }
  return result;
}

const Group* Description::find_group(std::string_view wanted) const {
  const auto found = group_numbers.find(wanted);
  return found == group_numbers.end() ? nullptr : &groups[found->second];
}

const VirtualJoint* Description::find_virtual_joint(std::string_view wanted) const {
  const auto found =
      std::find_if(virtual_joints.begin(), virtual_joints.end(),
                   [&](const VirtualJoint& one) { return one.name && *one.name == wanted; });
  return found == virtual_joints.end() ? nullptr : &*found;
}

}  // namespace smurf::srdf
