// SPDX-License-Identifier: BSD-3-Clause
// Mass, centre of mass and inertia of bodies and of sets of bodies.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// About the centre of mass, expressed in one frame F.
struct MassProperties {
  double mass = 0;                                    ///< kg
  Eigen::Vector3d center = Eigen::Vector3d::Zero();   ///< p_FC, m
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< kg m^2
};

/// The mass properties of one link in its link frame; absent values count as zero.
MassProperties mass_properties(const urdf::Link& link);
/// The same body seen from A: X_AB places the frame it is given in.
MassProperties transformed(const MassProperties& body_B, const Pose& X_AB);
/// Both bodies as one (parallel axis theorem).
MassProperties combined(const MassProperties& a, const MassProperties& b);
/// The mass properties of the whole robot in its root frame. `poses` are those that
/// forward_kinematics() returns.
MassProperties total(const LinkedModel& model, const std::vector<std::optional<Pose>>& poses);

}  // namespace smurf
