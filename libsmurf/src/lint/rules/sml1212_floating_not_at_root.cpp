// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const urdf::Joint& joint = model.robot->joints[i];
    const auto parent = model.tree.joint_parent[i];
    if (joint.type != urdf::JointType::floating || !parent) continue;
    const auto above = model.tree.parent_joint[to_size(*parent)];
    if (!above) continue;
    findings
        .report(joint.type_name.span, title(joint) + " is floating, but " +
                                          title(model.link(*parent)) + " is not the root")
        .label(name_place(model, model.joint(*above)), "leads to the parent");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "makes the joint fixed", "MARS smurf.cpp:918-921"},
    {&readers::pybullet, Effect::changes, "makes the joint fixed",
     "Bullet URDF2Bullet.cpp:491-497"},
    {&readers::gazebo, Effect::refuses, "refuses the file", kRun},
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

}  // namespace smurf::rules
