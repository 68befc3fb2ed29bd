// SPDX-License-Identifier: BSD-3-Clause
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
        .labels.push_back({name_place(model, model.joint(*above)), "leads to the parent"});
  }
}

}  // namespace

extern constinit const Rule sml1212_floating_not_at_root{
    .id = "SML1212",
    .name = "floating-not-at-root",
    .severity = Severity::error,
    .summary = "A floating joint hangs on a link that is not the root.",
    .why = "MuJoCo refuses the file: bodies float in the world only. Bullet and MARS make the "
           "joint fixed.",
    .remedy = "Let the joint begin at the root link, or use joints with one axis.",
    .sources = "MuJoCo 3.14, executed; Bullet URDF2Bullet.cpp:491-497; MARS smurf.cpp:918-921.",
    .check_model = check};

}  // namespace smurf::rules
