// SPDX-License-Identifier: BSD-3-Clause
// How a joint of a robot is built in the engine.
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
  Span place;  ///< where the annotation says so; empty when the URDF does
};

/// By joint; none for those that hold their links together. As in MARS, the section `joint` wins
/// over the URDF: it alone can ask for joints with two axes or for ball joints. Axes have the
/// length 1, or 0 when they are written so or are missing.
std::vector<std::optional<JointForm>> joint_forms(const LinkedModel& model);

}  // namespace smurf::load_check
