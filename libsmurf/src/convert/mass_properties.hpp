// SPDX-License-Identifier: BSD-3-Clause
// Mass, centre of mass and inertia of bodies and of sets of bodies.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// About the centre of mass, in the axes of one frame F.
struct MassProperties {
  double mass = 0;                                    ///< kg
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   ///< p_FC, m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< kg m^2
};

/// The mass properties of one link in its link frame; absent values count as zero.
MassProperties mass_properties(const urdf::Link& link);
/// The same body in the frame A; X_AB is the pose of its current frame.
MassProperties transformed(const MassProperties& body_B, const Pose& X_AB);
/// Combines two bodies (parallel axis theorem).
MassProperties combined(const MassProperties& a, const MassProperties& b);
/// The mass properties of the whole robot in its root frame. `poses` is the result of
/// forward_kinematics().
MassProperties total(const LinkedModel& model, const std::vector<std::optional<Pose>>& poses);

}  // namespace smurf
