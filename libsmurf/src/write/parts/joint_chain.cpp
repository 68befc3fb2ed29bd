// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/joint_chain.hpp"

namespace smurf {
namespace {

std::size_t child_of(const LinkedModel& model, JointIndex joint) {
  return to_size(*model.tree.joint_child[to_size(joint)]);
}

constexpr std::size_t kMostJoints = 6;  // MuJoCo refuses a body with more

/// Whether an importer needed a link for a joint that is beside the frame of its body. A link that
/// an author named stays: it may be massless in MuJoCo, if a link with mass is fixed to it.
bool is_made(const LinkedModel& model, std::size_t link, const urdf::Joint& joint,
             std::size_t child) {
  return joint.type == urdf::JointType::fixed &&
         link_name(model, link).starts_with(link_name(model, child) + "__");
}

}  // namespace

JointChain joint_chain(const LinkedModel& model, std::size_t link, const KeptParts& kept) {
  JointChain chain;
  chain.link = link;
  const urdf::Joint& first = model.joint(*model.tree.parent_joint[link]);
  chain.parts.push_back({&first, {}});
  chain.X_PB = urdf::to_pose(first.origin);
  if (!first.has_one_axis()) return chain;
  while (is_bare(model, chain.link, kept) && model.tree.child_joints[chain.link].size() == 1) {
    const JointIndex below = model.tree.child_joints[chain.link].front();
    const urdf::Joint& joint = model.joint(below);
    if (joint.has_one_axis() && chain.parts.size() == kMostJoints) break;
    if (!joint.has_one_axis() && !is_made(model, chain.link, joint, child_of(model, below))) break;
    const Pose X = urdf::to_pose(joint.origin);
    for (JointChain::Part& part : chain.parts) part.X_BJ = inverse(X) * part.X_BJ;
    chain.X_PB = chain.X_PB * X;
    if (joint.has_one_axis()) chain.parts.push_back({&joint, {}});
    chain.link = child_of(model, below);
  }
  return chain;
}

bool carries_mass(const LinkedModel& model, std::size_t link) {
  std::vector<std::size_t> open{link};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const JointIndex joint : model.tree.child_joints[at]) {
      if (model.joint(joint).type != urdf::JointType::fixed) continue;
      const std::size_t child = child_of(model, joint);
      if (inertial_of(model.robot->links[child])) return true;
      open.push_back(child);
    }
  }
  return false;
}

}  // namespace smurf
