// SPDX-License-Identifier: BSD-3-Clause
#include "lint/rigid_bodies.hpp"

#include <algorithm>
#include <numeric>

namespace smurf {
namespace {

/// By link: the topmost link of its body. Links that no root reaches are bodies of their own.
std::vector<std::size_t> bodies(const LinkedModel& model) {
  std::vector<std::size_t> body(model.robot ? model.robot->links.size() : 0);
  std::iota(body.begin(), body.end(), std::size_t{0});
  for (const LinkIndex link : model.tree.order) {
    const std::size_t i = to_size(link);
    const auto above = model.tree.parent_joint[i];
    const bool is_fixed = above && model.joint(*above).type == urdf::JointType::fixed;
    if (is_fixed) body[i] = body[to_size(*model.tree.joint_parent[to_size(*above)])];
  }
  return body;
}

}  // namespace

std::vector<bool> massless_bodies(const LinkedModel& model) {
  const std::vector<std::size_t> body = bodies(model);
  std::vector<bool> has_mass(body.size(), false);
  for (const LinkIndex link : model.tree.order) {
    const std::size_t i = to_size(link);
    const std::optional<urdf::Inertial>& inertial = model.link(link).inertial;
    // A mass that cannot be read is another finding, and may be any.
    if (inertial ? inertial->mass.value_or(1) > 0 : !model.link(link).collisions.empty()) {
      has_mass[body[i]] = true;
    }
  }
  std::vector<bool> result(body.size(), false);
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

std::vector<bool> fixed_to_heavier(const LinkedModel& model) {
  const std::vector<std::size_t> body = bodies(model);
  const auto mass_of = [&](std::size_t link) {
    const std::optional<urdf::Inertial>& inertial = model.robot->links[link].inertial;
    return inertial ? std::max(inertial->mass.value_or(0), 0.0) : 0.0;
  };
  std::vector<double> mass(body.size(), 0);  // by the topmost link
  for (std::size_t i = 0; i < body.size(); ++i) mass[body[i]] += mass_of(i);
  std::vector<bool> result(body.size());
  for (std::size_t i = 0; i < body.size(); ++i) {
    const double beside = mass[body[i]] - mass_of(i);
    result[i] = body[i] != i && beside > 0 && beside >= mass_of(i);
  }
  return result;
}

}  // namespace smurf
