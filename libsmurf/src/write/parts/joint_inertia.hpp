// SPDX-License-Identifier: BSD-3-Clause
// How hard the joints of a robot are to move, for motors that must be stable in a simulator.
#pragma once

#include <optional>
#include <vector>

#include "write/parts/scene_parts.hpp"

namespace smurf {

/// Of one joint, at the start position of a robot; kg m^2, or kg for a prismatic joint. Both are 0
/// for a joint that carries nothing, or that is not in the tree.
struct JointInertia {
  double free = 0;     ///< all other joints, and the base unless it is fixed, move freely
  double locked = 0;   ///< no other joint moves
  double gravity = 0;  ///< N m or N: the most that the weight of what it carries can do
};

/// By joint. `poses` are those of forward_kinematics(), `masses` those of the links as written.
std::vector<JointInertia> joint_inertias(const LinkedModel& model,
                                         const std::vector<std::optional<Pose>>& poses,
                                         const std::vector<std::optional<LinkInertial>>& masses,
                                         bool is_free, double gravity);

}  // namespace smurf
