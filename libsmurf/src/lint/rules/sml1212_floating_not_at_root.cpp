// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "link/mujoco_compiler.hpp"
#include "lint/mimic_queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1212_floating_not_at_root_file {
namespace {

constexpr Circumstance kFixedToRoot{"fixed to root"};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const std::set<std::string_view> followed = followed_joints(model);
  std::vector<bool> fixed, reached;  // by link; computed when they are needed
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const urdf::Joint& joint = model.robot->joints[i];
    const auto parent = model.tree.joint_parent[i];
    if (joint.type != urdf::JointType::floating || !parent) continue;
    const auto above = model.tree.parent_joint[to_size(*parent)];
    if (!above) continue;
    Diagnostic& diagnostic =
        findings.report(joint.type_name.span, title(joint) + " is floating, but " +
                                                  title(model.link(*parent)) + " is not the root");
    diagnostic.label(name_place(model, model.joint(*above)), "leads to the parent");
    if (joint.name && followed.contains(*joint.name)) diagnostic.when(kFollowed);
    if (reached.empty()) reached = reached_links(model);
    if (!reached[to_size(*parent)]) diagnostic.when(kUnreached);
    if (fixed.empty()) fixed = fixed_to_root(model);
    if (fixed[to_size(*parent)] && fuses_fixed_links(model)) {
      diagnostic.when(kFixedToRoot);
    }
  }
}

constexpr Fact kFacts[] = {
    drake_misses_leader(when(kFollowed)),
    {&readers::drake, Effect::takes, "makes a joint of six degrees of freedom", kRun},
    {&readers::mars, Effect::changes, "makes the joint fixed", "MARS smurf.cpp:918-921"},
    {&readers::pybullet, Effect::changes, "makes the joint fixed", kRun},
    {&readers::gazebo, Effect::takes, "leaves out what no root reaches", kRun, when(kUnreached)},
    {&readers::gazebo, Effect::refuses, "refuses the file", kRun},
    {&readers::mujoco, Effect::takes, "makes one body of the root and what is fixed to it", kRun,
     when(kFixedToRoot)},
    {&readers::mujoco, Effect::refuses, "refuses the file: bodies float in the world only", kRun},
    {&readers::urdfdom, Effect::takes, "accepts a floating joint anywhere", kRun},
    {&readers::phobos, Effect::takes, "accepts a floating joint anywhere", kRun},
};

}  // namespace

extern constinit const Rule sml1212_floating_not_at_root{
    .id = "SML1212",
    .name = "floating-not-at-root",
    .severity = Severity::error,
    .summary = "The parent of a floating joint is not the root link.",
    .remedy = "Make the root link the parent, or use joints with one axis.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1212_floating_not_at_root_file
