// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.tree.roots.empty()) return;  // a loop through the root has its own rule
  const std::vector<urdf::Joint>& joints = model.robot->joints;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const auto child = model.tree.joint_child[i];
    if (!child || !model.tree.joint_parent[i] || *model.tree.joint_parent[i] == *child) continue;
    const auto first = model.tree.parent_joint[to_size(*child)];
    if (!first || to_size(*first) == i) continue;
    const urdf::Joint& other = model.joint(*first);
    Diagnostic& diagnostic =
        findings.report(joints[i].child.span,
                        title(model.link(*child)) + " is already the child of " + title(other));
    diagnostic.caret = "a second parent";
    diagnostic.help = "keep one of the two joints; URDF has no closed chains";
    diagnostic.labels.push_back({other.child.span, "first made a child here"});
  }
}

}  // namespace

extern constinit const Rule sml1206_link_with_two_parents{
    .id = "SML1206",
    .name = "link-with-two-parents",
    .severity = Severity::error,
    .summary = "A link is the child of more than one joint.",
    .why = "urdfdom does not notice and keeps the alphabetically last joint; sdformat reports a "
           "duplicate link, MuJoCo refuses the file, DART and Bullet build something else each.",
    .remedy = "URDF cannot say closed chains: keep one joint, and write the other as a loop "
              "constraint where the target supports it.",
    .sources = "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14, DART 6.12 and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
