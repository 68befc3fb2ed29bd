// SPDX-License-Identifier: BSD-3-Clause
// The kinematic tree of a robot and its checks.
#pragma once

#include "smurf/linked.hpp"

namespace smurf {

/// Builds the tree of links and joints. Unknown ends stay empty; rules report them. Precondition:
/// model.robot is set and the name tables are filled.
KinematicTree build_tree(const LinkedModel& model);

/// Whether the product of the multipliers and offsets along a
/// joint's chain of leaders is small enough for computing
/// poses.
bool is_followable(const LinkedModel& model, const urdf::Joint& joint);

JointPositions to_joint_positions(const LinkedModel& model, const JointPoseSet& set);

/// The cost of computing the poses of all links of a model: one step for each link, and more for
/// each joint in a chain of mimics.
std::uint64_t steps_of_kinematics(const LinkedModel& model);

/// The position of one joint; mimic joints follow their leader. The length of the chain is limited,
/// so a cycle of mimics (which a rule reports) ends.
double position_of(const LinkedModel& model, const urdf::Joint& joint,
                   const JointPositions& positions);

}  // namespace smurf
