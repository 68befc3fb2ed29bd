// SPDX-License-Identifier: BSD-3-Clause
// Several joints of one body. A URDF has links without mass between them, with which no simulator
// can move.
#pragma once

#include <vector>

#include "write/parts/kept_parts.hpp"

namespace smurf {

struct JointChain {
  struct Part {
    const urdf::Joint* joint = nullptr;
    Pose X_BJ;  ///< the frame of the joint in the body, at the zero of all joints
  };
  std::size_t link = 0;  ///< the last one: the body
  Pose X_PB;             ///< in the link above the first joint, at the zero of all joints
  std::vector<Part> parts;
};

/// The joints from that above `link` to the first link which is more than a frame, at most six. One
/// joint, if that does not move.
JointChain joint_chain(const LinkedModel& model, std::size_t link, const KeptParts& kept);

/// Whether a link that is fixed to this one, or to such a link, has a mass.
bool carries_mass(const LinkedModel& model, std::size_t link);

}  // namespace smurf
