// SPDX-License-Identifier: BSD-3-Clause
#include "lint/rigid_bodies.hpp"

namespace smurf {

std::vector<bool> massless_bodies(const LinkedModel& model) {
  const std::size_t count = model.robot ? model.robot->links.size() : 0;
  std::vector<std::size_t> body(count);  // by link: the topmost link of its body
  std::vector<bool> has_mass(count, false);
  for (const LinkIndex link : model.tree.order) {
    const std::size_t i = to_size(link);
    const auto above = model.tree.parent_joint[i];
    const bool is_fixed = above && model.joint(*above).type == urdf::JointType::fixed;
    body[i] = is_fixed ? body[to_size(*model.tree.joint_parent[to_size(*above)])] : i;
    const std::optional<urdf::Inertial>& inertial = model.link(link).inertial;
    // A mass that cannot be read is another finding, and may be any.
    if (inertial ? inertial->mass.value_or(1) > 0 : !model.link(link).collisions.empty()) {
      has_mass[body[i]] = true;
    }
  }
  std::vector<bool> result(count, false);
  for (const LinkIndex link : model.tree.order) {
    const std::size_t top = body[to_size(link)];
    result[to_size(link)] = model.tree.parent_joint[top].has_value() && !has_mass[top];
  }
  return result;
}

bool has_fixed_mass(const LinkedModel& model, LinkIndex start) {
  std::vector<LinkIndex> queue{start};
  while (!queue.empty()) {
    const LinkIndex link = queue.back();
    queue.pop_back();
    if (model.link(link).inertial) return true;  // a wrong mass is another rule's finding
    for (const JointIndex below : model.tree.child_joints[to_size(link)]) {
      if (model.joint(below).type == urdf::JointType::fixed) {
        queue.push_back(*model.tree.joint_child[to_size(below)]);
      }
    }
  }
  return false;
}

}  // namespace smurf
