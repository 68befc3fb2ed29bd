// SPDX-License-Identifier: BSD-3-Clause
// The kinematic tree of a robot and its checks.
#pragma once

#include "smurf/linked.hpp"

namespace smurf {

/// Joins links by joints. Unknown ends stay empty; nothing is reported here, the rules look at the
/// result. Precondition: model.robot is set and the name tables are filled.
KinematicTree build_tree(const LinkedModel& model);

/// The joint positions that a joint pose set means in a model.
/// Whether the multipliers and offsets of the joints that a joint follows come to numbers that
/// poses can be computed with.
bool is_followable(const LinkedModel& model, const urdf::Joint& joint);

JointPositions to_joint_positions(const LinkedModel& model, const JointPoseSet& set);

/// What the poses of all links of a model take to compute: one step for each link, and more for
/// each joint that follows one that follows another.
std::uint64_t steps_of_kinematics(const LinkedModel& model);

/// Position of one joint, with mimic joints following their leader. The chain is bounded, so that a
/// cycle of mimics (which a rule reports) ends.
double position_of(const LinkedModel& model, const urdf::Joint& joint,
                   const JointPositions& positions);

}  // namespace smurf
