// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// True when the link is the other one or a descendant of it.
bool is_below(const LinkedModel& model, LinkIndex link, LinkIndex other) {
  for (std::size_t step = 0; step <= model.robot->joints.size() && link != other; ++step) {
    const auto above = model.tree.parent_joint[to_size(link)];
    if (!above || !model.tree.joint_parent[to_size(*above)]) return false;
    link = *model.tree.joint_parent[to_size(*above)];
  }
  return link == other;
}

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
    if (other.type == urdf::JointType::fixed) diagnostic.construct = "fixed";
    if (is_below(model, *model.tree.joint_parent[i], *child)) diagnostic.construct += "#ring";
    diagnostic.caret = "a second parent";
    diagnostic.help("keep one of the two joints; URDF has no closed chains");
    diagnostic.label(other.child.span, "the first joint to this link");
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes,
     "does not notice, and keeps the joint whose name is last in alphabetical order", kRun},
    {&readers::pybullet, Effect::changes, "keeps the last parent", "Bullet UrdfParser.cpp, run"},
    {&readers::gazebo, Effect::refuses, "reports a duplicate link", kRun},
    {&readers::dart, Effect::crashes, "never terminates", kRun, "#ring"},
    {&readers::dart, Effect::changes, "builds the link twice, or never terminates", kRun},
    {&readers::mujoco, Effect::refuses, "refuses several parents", kRun},
    {&readers::drake, Effect::refuses, "refuses the model when it is finalised",
     "Drake issue 19034"},
};

}  // namespace

extern constinit const Rule sml1206_link_with_two_parents{
    .id = "SML1206",
    .name = "link-with-two-parents",
    .severity = Severity::error,
    .summary = "A link is the child of more than one joint.",
    .remedy = "URDF cannot describe closed chains: keep one joint, and write the other as a loop "
              "constraint where the target supports it.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules
