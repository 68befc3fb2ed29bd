// SPDX-License-Identifier: BSD-3-Clause
// Tree building and forward kinematics, without recursion.
#include "link/kinematics.hpp"

#include <cmath>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/quantity.hpp"

namespace smurf {

namespace {

constexpr int kLongestChain = 64;

}  // namespace

bool is_followable(const LinkedModel& model, const urdf::Joint& joint) {
  double factor = 1;
  double sum = 0;
  const urdf::Joint* current = &joint;
  for (int step = 0; step < kLongestChain && current->mimic && current->mimic->joint; ++step) {
    const auto leader = model.joint_names.find(*current->mimic->joint);
    if (!leader) break;
    sum += factor * current->mimic->offset.value_or(0);
    factor *= current->mimic->multiplier.value_or(1);
    if (!is_quantity(sum) || !is_quantity(factor)) return false;
    current = &model.robot->joints[*leader];
  }
  return true;
}

double position_of(const LinkedModel& model, const urdf::Joint& joint,
                   const JointPositions& positions) {
  double factor = 1;
  double sum = 0;
  const urdf::Joint* current = &joint;
  for (int step = 0; step < kLongestChain; ++step) {
    if (!current->name) return sum;
    const auto given = positions.find(*current->name);
    if (given != positions.end()) return sum + factor * given->second;
    if (!current->mimic || !current->mimic->joint) return sum;
    const auto leader = model.joint_names.find(*current->mimic->joint);
    if (!leader) return sum;
    sum += factor * current->mimic->offset.value_or(0);
    factor *= current->mimic->multiplier.value_or(1);
    if (!is_quantity(sum) || !is_quantity(factor)) return 0;  // reported by the loader
    current = &model.robot->joints[*leader];
  }
  return sum;
}

namespace {

/// X_PC of a joint: its origin, then its motion.
Pose pose_of(const LinkedModel& model, const urdf::Joint& joint, const JointPositions& positions) {
  const Pose X_PJ = urdf::to_pose(joint.origin);
  if (!joint.has_one_axis()) return X_PJ;
  const double position = position_of(model, joint, positions);
  Vector3 axis = joint.axis.value_or(Vector3{1, 0, 0});
  const double length = hypotenuse(axis[0], axis[1], axis[2]);
  if (position == 0 || length == 0) return X_PJ;
  for (double& component : axis) component /= length;
  Pose X_JC;
  if (joint.type == urdf::JointType::prismatic) {
    for (std::size_t i = 0; i < 3; ++i) X_JC.position[i] = position * axis[i];
  } else {
    X_JC.orientation = from_axis_angle(axis, position);
  }
  return X_PJ * X_JC;
}

}  // namespace

KinematicTree build_tree(const LinkedModel& model) {
  const std::vector<urdf::Link>& links = model.robot->links;
  const std::vector<urdf::Joint>& joints = model.robot->joints;
  KinematicTree tree;
  tree.joint_parent.resize(joints.size());
  tree.joint_child.resize(joints.size());
  tree.parent_joint.resize(links.size());
  tree.child_joints.resize(links.size());
  const auto find = [&](const Field<std::string>& name) {
    return name ? model.link_index(*name) : std::nullopt;
  };
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const JointIndex joint{static_cast<std::uint32_t>(i)};
    const auto parent = tree.joint_parent[i] = find(joints[i].parent);
    const auto child = tree.joint_child[i] = find(joints[i].child);
    if (!parent || !child || *parent == *child) continue;
    std::optional<JointIndex>& above = tree.parent_joint[to_size(*child)];
    if (above) continue;  // the first parent is kept
    above = joint;
    tree.child_joints[to_size(*parent)].push_back(joint);
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!tree.parent_joint[i]) tree.roots.push_back(LinkIndex{static_cast<std::uint32_t>(i)});
  }
  tree.order = tree.roots;
  for (std::size_t at = 0; at < tree.order.size(); ++at) {
    const std::size_t parent = to_size(tree.order[at]);
    for (const JointIndex joint : tree.child_joints[parent]) {
      tree.order.push_back(*tree.joint_child[to_size(joint)]);
    }
  }
  return tree;
}

std::uint64_t steps_of_kinematics(const LinkedModel& model) {
  if (!model.robot) return 0;
  std::uint64_t steps = model.robot->links.size();
  for (const urdf::Joint& joint : model.robot->joints) {
    if (!joint.mimic || !joint.mimic->joint) continue;
    const auto leader = model.joint_names.find(*joint.mimic->joint);
    const bool is_chain = leader && model.robot->joints[*leader].mimic;
    steps += is_chain ? kLongestChain : 1;
  }
  return steps;
}

std::vector<std::optional<Pose>> forward_kinematics(const LinkedModel& model,
                                                    const JointPositions& positions) {
  std::vector<std::optional<Pose>> poses;
  if (!model.robot) return poses;
  poses.resize(model.robot->links.size());
  if (model.tree.roots.empty()) return poses;
  poses[to_size(model.tree.roots.front())] = Pose{};
  for (const LinkIndex link : model.tree.order) {
    const std::optional<JointIndex> above = model.tree.parent_joint[to_size(link)];
    if (!above) continue;
    const std::optional<Pose>& X_RP = poses[to_size(*model.tree.joint_parent[to_size(*above)])];
    if (X_RP) poses[to_size(link)] = *X_RP * pose_of(model, model.joint(*above), positions);
  }
  return poses;
}

JointPositions to_joint_positions(const LinkedModel& model, const JointPoseSet& set) {
  JointPositions positions;
  for (const JointPoseSet::Entry& entry : set.joints) {
    if (!entry.position || !is_quantity(*entry.position)) continue;
    // In MARS, entries move the joint of the motor with this name (SimEntity.cpp:505-511); Phobos
    // writes joint names. A name of both a motor and another joint means the motor.
    const Motor* motor = model.find_motor(entry.name.value);
    const bool drives = motor != nullptr && motor->joint;
    positions[drives ? *motor->joint : entry.name.value] = *entry.position;
  }
  return positions;
}

std::optional<JointPositions> joint_positions(const LinkedModel& model,
                                              std::string_view pose_name) {
  for (const JointPoseSet& set : model.annotations.poses) {
    if (set.name && *set.name == pose_name) return to_joint_positions(model, set);
  }
  return std::nullopt;
}

}  // namespace smurf
