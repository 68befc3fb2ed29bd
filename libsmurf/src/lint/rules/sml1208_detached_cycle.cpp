// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.tree.roots.empty()) return;
  std::vector<bool> is_reached(model.robot->links.size(), false);
  for (const LinkIndex link : model.tree.order) is_reached[to_size(link)] = true;
  for (std::size_t i = 0; i < is_reached.size(); ++i) {
    if (is_reached[i]) continue;
    // One diagnostic a ring: walk up until a link comes again and mark what was seen.
    std::size_t at = i;
    while (!is_reached[at]) {
      is_reached[at] = true;
      at = to_size(*model.tree.joint_parent[to_size(*model.tree.parent_joint[at])]);
    }
    const urdf::Joint& joint = model.joint(*model.tree.parent_joint[i]);
    findings.report(joint.child.span,
                    title(model.robot->links[i]) + " is part of a ring that no root link reaches");
    std::vector<std::size_t> queue{i};
    while (!queue.empty()) {
      const std::size_t link = queue.back();
      queue.pop_back();
      for (const JointIndex below : model.tree.child_joints[link]) {
        const std::size_t child = to_size(*model.tree.joint_child[to_size(below)]);
        if (is_reached[child]) continue;
        is_reached[child] = true;
        queue.push_back(child);
      }
    }
  }
}

}  // namespace

extern constinit const Rule sml1208_detached_cycle{
    .id = "SML1208",
    .name = "detached-cycle",
    .severity = Severity::error,
    .summary = "Links form a ring that the root does not reach.",
    .why = "urdfdom accepts it and the ring is silently missing in Gazebo and DART.",
    .remedy = "Connect the ring to the rest and remove the joint that closes it.",
    .sources = "urdfdom 3.0.1, sdformat 12.3 and DART 6.12, executed.",
    .check_model = check};

}  // namespace smurf::rules
