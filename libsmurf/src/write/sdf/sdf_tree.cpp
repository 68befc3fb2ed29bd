// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf/sdf_tree.hpp"

#include <map>
#include <string>

#include "write/sdf/sdf_names.hpp"

namespace smurf {
namespace {

bool is_identity(const urdf::Joint& joint) {
  const Pose X = urdf::to_pose(joint.origin);
  const Quaternion& q = X.orientation;
  return X.position == Vector3{} && q.x == 0 && q.y == 0 && q.z == 0;
}

bool turns_freely_about(const urdf::Joint& joint, const Vector3& axis) {
  return joint.type == urdf::JointType::continuous && joint.axis.value_or({1, 0, 0}) == axis &&
         !joint.mimic && !joint.dynamics;
}

class TreeBuilder {
 public:
  TreeBuilder(const LinkedModel& model, const KeptParts& kept) : model_(model), kept_(kept) {}

  SdfTree build() {
    result_.bodies = sdf_bodies(model_, false);
    const std::size_t root = to_size(model_.tree.roots.front());
    std::size_t in_root = 0;
    for (const std::size_t body : result_.bodies) in_root += body == root ? 1 : 0;
    result_.has_world =
        link_name(model_, root) == "world" && in_root == 1 && is_bare(model_, root, kept_);
    find_masses(root);
    std::vector<bool> is_written(model_.robot->links.size());
    for (const LinkIndex link : model_.tree.order) {
      const std::size_t at = to_size(link);
      const auto& above = model_.tree.parent_joint[at];
      if (!above || is_written[at]) continue;
      SdfJoint joint{.joint = &model_.joint(*above),
                     .parent = to_size(*model_.tree.joint_parent[to_size(*above)]),
                     .frame = at};
      take_several(joint, is_written);
      const std::size_t body = result_.bodies[joint.frame];
      if (result_.bodies[joint.parent] != body) result_.joints.push_back(joint);
    }
    return std::move(result_);
  }

 private:
  /// A body whose first link has no mass gets that of the first link with mass that is fixed to it.
  /// The root stays a link, since plug-ins name it.
  void find_masses(std::size_t root) {
    std::map<std::size_t, std::size_t> heavy;  // body -> the link that it becomes
    for (const LinkIndex link : model_.tree.order) {
      const std::size_t at = to_size(link);
      const auto& above = model_.tree.parent_joint[at];
      if (!above || model_.joint(*above).type != urdf::JointType::fixed) continue;
      const std::size_t parent = to_size(*model_.tree.joint_parent[to_size(*above)]);
      const std::size_t body = result_.bodies[parent];
      if (body == root) continue;
      if (body == result_.bodies[at] || inertial_of(model_.robot->links[body])) continue;
      heavy.emplace(body, at);
    }
    for (std::size_t& body : result_.bodies) {
      const auto found = heavy.find(body);
      if (found != heavy.end()) body = found->second;
    }
  }

  /// The only joint below a bare link between two joints, at its frame; null if there is none.
  const urdf::Joint* next(std::size_t link) const {
    const std::vector<JointIndex>& below = model_.tree.child_joints[link];
    if (!is_bare(model_, link, kept_) || below.size() != 1) return nullptr;
    const urdf::Joint& joint = model_.joint(below.front());
    const bool is_kept = kept_.joints[to_size(below.front())];
    return is_identity(joint) && joint.name && !is_kept ? &joint : nullptr;
  }

  std::size_t child_of(const urdf::Joint& joint) const {
    const auto index = static_cast<std::size_t>(&joint - model_.robot->joints.data());
    return to_size(*model_.tree.joint_child[index]);
  }

  /// Joints that the readers of SDF make of one.
  void take_several(SdfJoint& joint, std::vector<bool>& is_written) {
    const urdf::Joint& first = *joint.joint;
    const urdf::Joint* second = first.name ? next(joint.frame) : nullptr;
    if (second == nullptr) return;
    const std::string& name = *first.name;
    const auto drop = [&](std::size_t link, const urdf::Joint& below) {
      result_.bodies[link] = SdfTree::kNoBody;
      joint.frame = child_of(below);
      is_written[joint.frame] = true;
    };
    const std::size_t between = joint.between = joint.frame;
    if (*second->name == name + "_2" && turns(first) && turns(*second)) {
      joint.kind = SdfJointKind::universal;
      joint.second = second;
      return drop(between, *second);
    }
    const bool follows = second->mimic && second->mimic->joint && *second->mimic->joint == name;
    if (*second->name == name + "_2" && turns(first) && follows &&
        second->type == urdf::JointType::prismatic && second->mimic->multiplier.value_or(1) != 0 &&
        first.axis.value_or({1, 0, 0}) == second->axis.value_or({1, 0, 0})) {
      joint.kind = SdfJointKind::screw;
      joint.second = second;
      return drop(between, *second);
    }
    if (!name.ends_with("_x") || !turns_freely_about(first, {1, 0, 0}) ||
        kept_.joints[index_of(first)])
      return;
    const std::string stem = name.substr(0, name.size() - 2);
    const urdf::Joint* third = next(child_of(*second));
    if (third == nullptr || *second->name != stem + "_y" || *third->name != stem + "_z" ||
        !turns_freely_about(*second, {0, 1, 0}) || !turns_freely_about(*third, {0, 0, 1}))
      return;
    joint.kind = SdfJointKind::ball;
    const std::size_t last = child_of(*second);
    drop(between, *second);
    drop(last, *third);
  }

  std::size_t index_of(const urdf::Joint& joint) const {
    return static_cast<std::size_t>(&joint - model_.robot->joints.data());
  }
  static bool turns(const urdf::Joint& joint) {
    return (joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::continuous) &&
           !joint.mimic;
  }

  const LinkedModel& model_;
  const KeptParts& kept_;
  SdfTree result_;
};

}  // namespace

SdfTree sdf_tree(const LinkedModel& model, const KeptParts& kept) {
  return TreeBuilder(model, kept).build();
}

}  // namespace smurf
