// SPDX-License-Identifier: BSD-3-Clause
// The bodies and joints that a model has in SDF. A URDF needs links without mass where a joint is
// beside the frame of its child, and where a joint has several axes; SDF says both in the joint.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "write/parts/kept_parts.hpp"

namespace smurf {

enum class SdfJointKind : std::uint8_t { single, ball, universal, screw };

struct SdfJoint {
  SdfJointKind kind = SdfJointKind::single;
  const urdf::Joint* joint = nullptr;   ///< the first, if a URDF needs several
  const urdf::Joint* second = nullptr;  ///< of a universal joint, and of a screw
  std::size_t parent = 0;               ///< link
  std::size_t between = 0;              ///< the link that a URDF needs behind the first joint
  std::size_t frame = 0;                ///< the link whose frame is that of the joint
};

struct SdfTree {
  static constexpr std::size_t kNoBody = static_cast<std::size_t>(-1);

  std::vector<std::size_t> bodies;  ///< by link: the link whose body contains it
  std::vector<SdfJoint> joints;     ///< between bodies, in the order of the tree
  /// Whether the root stands for the world only: it has its name, no mass and nothing else.
  bool has_world = false;
};

/// Links without mass belong to a body that they are fixed to.
SdfTree sdf_tree(const LinkedModel& model, const KeptParts& kept);

}  // namespace smurf
