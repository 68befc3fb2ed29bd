// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// Roots that stand there because a joint names an unknown link, or one link twice, are the fault
/// of that joint.
bool has_broken_joints(const LinkedModel& model) {
  for (std::size_t i = 0; i < model.tree.joint_parent.size(); ++i) {
    const auto parent = model.tree.joint_parent[i];
    const auto child = model.tree.joint_child[i];
    if (!parent || !child || *parent == *child) return true;
  }
  return false;
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.tree.roots.size() < 2 || has_broken_joints(model)) return;
  const urdf::Link& first = model.link(model.tree.roots.front());
  for (std::size_t i = 1; i < model.tree.roots.size(); ++i) {
    const urdf::Link& root = model.link(model.tree.roots[i]);
    // A second link of the same name is no root of its own; the duplicate is reported.
    if (root.name && model.link_names.find(*root.name) != to_size(model.tree.roots[i])) continue;
    if (!root.name || root.name->empty()) continue;
    Diagnostic& diagnostic =
        findings.report(name_place(model, root), "no joint leads to " + title(root) +
                                                     ", so the robot has several root links");
    diagnostic.caret = "also a root";
    diagnostic.help = "connect it by a joint, or delete it";
    diagnostic.labels.push_back({name_place(model, first), "the first root link"});
  }
}

}  // namespace

extern constinit const Rule sml1204_several_roots{
    .id = "SML1204",
    .name = "several-roots",
    .severity = Severity::error,
    .summary = "A robot has more than one link that no joint leads to.",
    .why = "urdfdom (RViz, Gazebo, DART, Pinocchio, KDL) refuses the file, Bullet ends with root "
           "index -1, MuJoCo welds all of them to the world.",
    .remedy = "Connect the links by joints; a link that nothing needs can go.",
    .sources = "urdfdom 3.0.1, sdformat 12.3, Bullet and MuJoCo 3.14, executed; urdf_model "
               "model.h:176.",
    .check_model = check};

}  // namespace smurf::rules
