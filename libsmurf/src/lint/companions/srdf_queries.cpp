// SPDX-License-Identifier: BSD-3-Clause
// Sources: srdfdom model.cpp; moveit2 robot_model.cpp.
#include "lint/companions/srdf_queries.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "base/deadline.hpp"
#include "base/files/path.hpp"

namespace smurf {
namespace {

/// The links from one up to the root, with the joints above them. A ring ends at its first link.
std::vector<LinkIndex> way_up(const LinkedModel& model, LinkIndex from) {
  std::vector<LinkIndex> way{from};
  while (way.size() <= model.robot->links.size()) {
    const auto joint = model.tree.parent_joint[to_size(way.back())];
    if (!joint) break;
    const auto parent = model.tree.joint_parent[to_size(*joint)];
    if (!parent) break;
    way.push_back(*parent);
  }
  return way;
}

class Collector {
 public:
  Collector(const LinkedModel& model, const srdf::Description& srdf)
      : model_(model),
        srdf_(srdf),
        most_groups_(
            std::min(kMostGroups, kMostOfAll / std::max<std::size_t>(srdf.groups.size(), 1) + 1)) {
    result_.of_robot.resize(model.robot->joints.size());
  }

  /// Not recursive: groups may be nested as deep as the file is long.
  void add(const srdf::Group& group) {
    note(group);
    while (!waiting_.empty()) {
      const srdf::Group* one = waiting_.back();
      waiting_.pop_back();
      for (const srdf::Member& member : one->members) add(member);
    }
  }

  GroupJoints take() { return std::move(result_); }

 private:
  void note(const srdf::Group& group) {
    Deadline::look(4);
    if (seen_.size() == most_groups_) {
      result_.is_complete = false;
    } else if (seen_.insert(&group).second) {
      waiting_.push_back(&group);
    }
  }

  void add(const srdf::Member& member) {
    switch (member.kind) {
    case srdf::Member::Kind::joint: return add_joint(member.name);
    case srdf::Member::Kind::link: return add_link(member.name);
    case srdf::Member::Kind::chain: return add_chain(member);
    case srdf::Member::Kind::group: break;
    }
    const srdf::Group* group = member.name ? srdf_.find_group(*member.name) : nullptr;
    if (group == nullptr) {
      result_.is_complete = false;
    } else {
      note(*group);
    }
  }

  void add_joint(const srdf::Text& name) {
    const auto index = name ? model_.joint_index(*name) : std::nullopt;
    const srdf::VirtualJoint* one = name ? srdf_.find_virtual_joint(*name) : nullptr;
    if (index) {
      result_.of_robot[to_size(*index)] = true;
    } else if (one != nullptr) {
      result_.virtual_joints.push_back(one);
    } else {
      result_.is_complete = false;
    }
  }

  void add_link(const srdf::Text& name) {
    const auto index = name ? model_.link_index(*name) : std::nullopt;
    if (!index) {
      result_.is_complete = false;
    } else if (const auto joint = model_.tree.parent_joint[to_size(*index)]) {
      result_.of_robot[to_size(*joint)] = true;
    }
  }

  void add_chain(const srdf::Member& member) {
    const bool has_ends = member.base && member.tip && model_.link_index(*member.base) &&
                          model_.link_index(*member.tip);
    const Chain chain = has_ends ? chain_between(model_, *member.base, *member.tip) : Chain{};
    if (!chain.is_joined) result_.is_complete = false;
    for (const JointIndex joint : chain.joints) result_.of_robot[to_size(joint)] = true;
  }

  // Robots have a dozen groups. The joints of each are collected for several rules, so that groups
  // in groups would cost the square of their number.
  static constexpr std::size_t kMostGroups = 200;
  static constexpr std::size_t kMostOfAll = 40'000;

  const LinkedModel& model_;
  const srdf::Description& srdf_;
  const std::size_t most_groups_;
  GroupJoints result_;
  std::set<const srdf::Group*> seen_;
  std::vector<const srdf::Group*> waiting_;
};

}  // namespace

void for_each_srdf(const Companions& companions,
                   const std::function<void(const srdf::Description&)>& visit) {
  for (const Companion& one : companions.files) {
    if (one.srdf) visit(*one.srdf);
  }
}

Span tag_of(const srdf::Description& srdf, xml::ElementId element) {
  return xml::View(srdf.document, element).name_span();
}

Span place_of(const srdf::Description& srdf, const srdf::Text& text, xml::ElementId element) {
  return text && !text->empty() ? text.span : tag_of(srdf, element);
}

std::string title_of(std::string_view kind, const srdf::Text& name) {
  return name ? std::string(kind) + " " + quoted(*name) : "this " + std::string(kind);
}

bool GroupJoints::contains(const LinkedModel& model, std::string_view joint) const {
  if (const auto index = model.joint_index(joint)) return of_robot[to_size(*index)];
  return std::any_of(virtual_joints.begin(), virtual_joints.end(),
                     [&](const srdf::VirtualJoint* one) { return *one->name == joint; });
}

GroupJoints joints_of(const LinkedModel& model, const srdf::Description& srdf,
                      const srdf::Group& group) {
  Collector collector(model, srdf);
  collector.add(group);
  return collector.take();
}

void for_each_state(const LinkedModel& model, const Companions& companions,
                    const std::function<void(const srdf::Description&, const srdf::GroupState&,
                                             const GroupJoints&)>& visit) {
  if (!model.robot) return;
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    std::map<const srdf::Group*, GroupJoints> known;
    for (const srdf::GroupState& state : srdf.states) {
      const srdf::Group* group = state.group ? srdf.find_group(*state.group) : nullptr;
      if (group == nullptr) continue;
      const auto [joints, is_new] = known.try_emplace(group);
      if (is_new) joints->second = joints_of(model, srdf, *group);
      visit(srdf, state, joints->second);
    }
  });
}

Chain chain_between(const LinkedModel& model, std::string_view base, std::string_view tip) {
  const std::vector<LinkIndex> from_tip = way_up(model, *model.link_index(tip));
  const std::vector<LinkIndex> from_base = way_up(model, *model.link_index(base));
  Deadline::look((from_tip.size() + from_base.size()) / 8);
  // Looking for each link of one way in the other costs the square of a robot's depth.
  std::vector<std::size_t> place_in_tip(model.robot->links.size(), from_tip.size());
  for (std::size_t i = from_tip.size(); i-- > 0;) place_in_tip[to_size(from_tip[i])] = i;
  Chain chain;
  for (const LinkIndex link : from_base) {
    const auto common = from_tip.begin() + static_cast<std::ptrdiff_t>(place_in_tip[to_size(link)]);
    if (common == from_tip.end()) continue;
    chain.is_joined = true;
    chain.is_below = link == from_base.front();
    for (auto one = from_tip.begin(); one != common; ++one) {
      chain.joints.push_back(*model.tree.parent_joint[to_size(*one)]);
    }
    for (const LinkIndex one : from_base) {
      if (one == link) break;
      chain.joints.push_back(*model.tree.parent_joint[to_size(one)]);
    }
    break;
  }
  return chain;
}

std::size_t variables_of(const urdf::Joint& joint) {
  switch (joint.type) {
  case urdf::JointType::fixed: return 0;
  case urdf::JointType::planar: return 3;
  case urdf::JointType::floating: return 7;
  default: return 1;
  }
}

std::size_t variables_of(const srdf::VirtualJoint& joint) {
  const std::string type = joint.type ? path::to_lower(*joint.type) : std::string();
  if (type == "planar") return 3;
  return type == "floating" ? 7 : 0;
}

}  // namespace smurf
