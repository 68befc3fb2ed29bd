// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3506_srdf_virtual_joint_child_file {
namespace {

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot || model.tree.roots.size() != 1) return;
  const urdf::Link& root = model.link(model.tree.roots.front());
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::VirtualJoint& joint : srdf.virtual_joints) {
      if (!joint.child_link || model.find_link(*joint.child_link) == nullptr) continue;
      if (!root.name || *joint.child_link == *root.name) continue;
      Diagnostic& found =
          findings
              .report(joint.child_link.span, title_of("virtual joint", joint.name) + " attaches " +
                                                 quoted(*joint.child_link) +
                                                 ", which is not the root of the robot")
              .label(root.name.span, "this link is the root")
              .help("attach the root " + quoted(*root.name));
      // A robot that stands on a link `world` is fixed to that frame in any case.
      const bool is_there = !joint.parent_frame || *joint.parent_frame == "world";
      if (*root.name == "world" && is_there) found.severity = Severity::info;
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::loses, "does not use the virtual joint",
     "moveit2 robot_model.cpp buildRecursive, constructJointModel"},
};

}  // namespace

extern constinit const Rule sml3506_srdf_virtual_joint_child{
    .id = "SML3506",
    .name = "srdf-virtual-joint-child",
    .severity = Severity::warning,
    .summary = "A virtual joint attaches a link that is not the root of the robot.",
    .why = "The robot stays fixed to the world, and groups with the joint lack it.",
    .remedy = "Write the root link as `child_link`.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3506_srdf_virtual_joint_child_file
