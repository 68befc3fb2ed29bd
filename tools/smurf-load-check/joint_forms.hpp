// SPDX-License-Identifier: BSD-3-Clause
// The engine's counterparts of the joints of a robot.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf::load_check {

enum class JointKind : std::uint8_t { hinge, slider, universal, ball, planar, floating };

struct JointForm {
  JointKind kind = JointKind::hinge;
  Eigen::Vector3d axis_C = Eigen::Vector3d::UnitX();  ///< child's frame; planar: the plane's normal
  Eigen::Vector3d axis2_C = Eigen::Vector3d::Zero();  ///< universal
  Span place;  ///< place in the annotation; empty if the URDF defines it
};

/// By joint; none for joints that hold their links together. As in MARS, the section `joint`
/// overrides the URDF: only it can define joints with two axes or ball joints. Axes have the length
/// 1, or 0 if they are written so or are missing.
std::vector<std::optional<JointForm>> joint_forms(const LinkedModel& model);

}  // namespace smurf::load_check
