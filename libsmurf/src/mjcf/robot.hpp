// SPDX-License-Identifier: BSD-3-Clause
// The results of a model: a URDF and annotations.
#pragma once

#include <array>
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
  double ratio =
      0;  ///< above 0: the damping in place of `kv`, 1 where the joint just does not swing
};
/// The attributes of an actuator, with those of its class.
Settings settings_of_actuator(const Reference& one);
/// The first number of `gear`, which joints with one axis have; 1 where it cannot be used.
double gear_of(const Settings& settings, Reporter& reporter);
/// Gives joints the armature and the damping of their actuators, which MuJoCo adds to theirs.
void add_actuators(Model& model, Reporter& reporter);
/// None for other actuators, such as muscles. A `general` one may be one of them.
std::optional<Servo> servo_of(const Settings& s, Reporter& reporter);
/// The lowest and the largest torque or force of an actuator at its joint, N m or N: the range of
/// the force and, of a motor, that of the control, times the gear.
std::optional<std::array<double, 2>> effort_range_of(const Settings& settings, Reporter& reporter);

/// Of MuJoCo: sliding, torsional and rolling.
inline constexpr std::array<double, 3> kUsualFriction{1, 0.005, 0.0001};
std::array<double, 3> friction_of(const Geom& geom, Reporter& reporter);
/// Reports what MuJoCo simulates, and neither a URDF nor SMURF says: how contacts, limits and
/// friction give way, bodies that are held against gravity or moved by a program, and so on.
void report_unsaid(const Model& model, Reporter& reporter);

/// "" if there are neither motors nor poses.
std::string write_annotations(const Model& model, Reporter& reporter, xacro::Expansion& expansion);
std::string write_robot(const Model& model, const JointFacts& facts, Reporter& reporter,
                        xacro::Expansion& expansion);

}  // namespace smurf::mjcf
