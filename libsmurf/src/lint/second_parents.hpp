// SPDX-License-Identifier: BSD-3-Clause
// Links to which several joints lead, and the root that one of them was meant to lead to.
#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// The joints whose child already has a parent, by an earlier joint. Links of one name are left
/// out: the name is reported, and each of the joints may be meant for another link.
inline std::vector<std::size_t> second_parents(const LinkedModel& model) {
  std::set<std::string_view> names, repeated;
  for (const urdf::Link& link : model.robot->links) {
    if (link.name && !names.insert(*link.name).second) repeated.insert(*link.name);
  }
  std::vector<std::size_t> joints;
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const auto child = model.tree.joint_child[i];
    const auto parent = model.tree.joint_parent[i];
    if (!child || !parent || *parent == *child || repeated.contains(*model.link(*child).name)) {
      continue;
    }
    const auto first = model.tree.parent_joint[to_size(*child)];
    if (first && to_size(*first) != i) joints.push_back(i);
  }
  return joints;
}

/// The only root besides the first, if also one joint too many leads to another link.
inline std::optional<LinkIndex> missed_root(const LinkedModel& model) {
  if (model.tree.roots.size() != 2 || second_parents(model).size() != 1) return std::nullopt;
  const LinkIndex root = model.tree.roots.back();
  const Field<std::string>& name = model.link(root).name;
  const bool is_first = name && model.link_names.find(*name) == to_size(root);
  return is_first ? std::optional(root) : std::nullopt;
}

}  // namespace smurf
