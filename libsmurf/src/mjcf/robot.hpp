// SPDX-License-Identifier: BSD-3-Clause
// The results of a model: a URDF and annotations.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mjcf/parts_by_name.hpp"

namespace smurf::mjcf {

/// A joint follows another: `<equality><joint>`.
struct Follower {
  std::string leader;
  double multiplier = 1, offset = 0;
  View element;
};

/// Two links that are held together beside the tree: `<connect>` and `<weld>`.
struct ClosedLoop {
  std::string name, parent, child;
  bool is_ball = false;  ///< else fixed
  Pose X_CJ;             ///< in the child
  View element;
  xacro::FrameId frame = xacro::kNoFrame;
};
/// None if a joint in `<gazebo>` would close the loop elsewhere.
std::optional<ClosedLoop> closed_loop(const Model& model, const PartsByName& parts,
                                      const Reference& one, const Settings& settings,
                                      Reporter& reporter);

/// What sections outside of the tree say about joints, and which bodies must not touch.
struct JointFacts {
  std::vector<std::pair<std::string, std::string>> excluded;
  std::vector<ClosedLoop> loops;
  std::map<std::string, Follower> followers;
  std::map<std::string, std::pair<double, Place>> efforts;  ///< of the actuators
};
JointFacts facts_of_joints(const Model& model, Reporter& reporter);

/// An actuator that SMURF has as a motor.
struct Servo {
  std::string_view kind;  ///< "motor", "position", "velocity" or "intvelocity"
  double gain = 1;        ///< of a motor: force by command
  double kp = 0, kv = 0;  ///< before the gear
};
/// None for other actuators, such as muscles. A `general` one may be one of them.
std::optional<Servo> servo_of(const Settings& s, Reporter& reporter);
/// The largest torque or force of an actuator: the range of the force, or of the control of a
/// motor, times the gear.
std::optional<double> effort_of(const Settings& settings, Reporter& reporter);

/// "" if there are neither motors nor poses.
std::string write_annotations(const Model& model, Reporter& reporter, xacro::Expansion& expansion);
std::string write_robot(const Model& model, const JointFacts& facts, Reporter& reporter,
                        xacro::Expansion& expansion);

}  // namespace smurf::mjcf
