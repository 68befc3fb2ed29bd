// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mimic_queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1213_floating_or_planar_file {
namespace {

constexpr Circumstance kOneDamping{"one damping for three"};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const std::set<std::string_view> followed = followed_joints(model);
  std::vector<bool> reached;  // by link; computed when it is needed
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const urdf::Joint& joint = model.robot->joints[i];
    const bool is_floating = joint.type == urdf::JointType::floating;
    if (!is_floating && joint.type != urdf::JointType::planar) continue;
    const auto parent = model.tree.joint_parent[i];
    // SML1212 reports a floating joint below another joint.
    if (is_floating && parent && model.tree.parent_joint[to_size(*parent)]) continue;
    Diagnostic& diagnostic =
        findings
            .report(joint.type_name.span,
                    title(joint) + " is " + *joint.type_name + ", which few readers can move")
            .note(std::string(is_floating ? "MARS and Bullet make" : "MARS makes") +
                  " the joint fixed; Gazebo cannot build the model");
    if (joint.name && followed.contains(*joint.name)) diagnostic.when(kFollowed);
    if (reached.empty()) reached = reached_links(model);
    if (parent && !reached[to_size(*parent)]) diagnostic.when(kUnreached);
    if (!is_floating && joint.dynamics && joint.dynamics->damping.written) {
      diagnostic.when(kOneDamping);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "makes the joint fixed", "MARS smurf.cpp:918-921"},
    {&readers::pybullet, Effect::takes, "makes a planar joint", kRun, when(kInPlanar)},
    {&readers::pybullet, Effect::changes, "makes the joint fixed", kRun},
    {&readers::gazebo, Effect::takes, "leaves out what no root reaches", kRun, when(kUnreached)},
    {&readers::gazebo, Effect::refuses, "cannot build the model", kRun},
    {&readers::drake, Effect::refuses,
     "needs three dampings in a planar joint, and refuses the file", kRun, when(kOneDamping)},
    drake_misses_leader(when(kFollowed).unless(kInPlanar)),
    {&readers::drake, Effect::changes, "drops the origin of a floating joint", kRun},
    {&readers::pinocchio, Effect::changes, "ignores the normal of a planar joint", kRun,
     when(kInPlanar)},
};

}  // namespace

extern constinit const Rule sml1213_floating_or_planar{
    .id = "SML1213",
    .name = "floating-or-planar",
    .severity = Severity::warning,
    .summary = "A joint is floating or planar.",
    .remedy = "Place a free robot in the scene instead; write a planar joint as two prismatic and "
              "one continuous joint.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1213_floating_or_planar_file
