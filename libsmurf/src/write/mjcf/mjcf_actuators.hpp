// SPDX-License-Identifier: BSD-3-Clause
// The motors of a MuJoCo world.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "write/mjcf/mjcf_parts.hpp"
#include "write/parts/joint_drives.hpp"

namespace smurf {

/// A joint that follows another joint; both by their names in the world.
struct MjcfFollower {
  std::string joint, leader;
  double offset = 0, multiplier = 1;
};

class MjcfActuators : protected MjcfParts {
 public:
  using MjcfParts::MjcfParts;

 protected:
  /// <actuator>, and the commands in the keyframe that keep the start position.
  void add_actuators();
  void append_driven_followers(std::vector<MjcfFollower>& followers) const;

 private:
  void add_actuator(std::size_t instance, const JointDrive& drive);
};

}  // namespace smurf
