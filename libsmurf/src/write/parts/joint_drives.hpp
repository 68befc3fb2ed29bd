// SPDX-License-Identifier: BSD-3-Clause
// The drives of the joints of a model: SMURF motors, else ros2_control, else transmissions, with
// the kinds and gains of controllers and of the caller.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "smurf/linked.hpp"
#include "smurf/write_scene.hpp"
#include "write/parts/joint_inertia.hpp"

namespace smurf {

/// The commanded quantity.
enum class DriveKind : std::uint8_t { position, velocity, effort };

struct JointDrive {
  const Motor* motor = nullptr;  ///< null if an element of the URDF states it
  const urdf::Joint* joint = nullptr;
  DriveKind kind = DriveKind::position;
  std::string name;                          ///< name of the motor; otherwise of the joint
  xml::ElementId element = xml::kNoElement;  ///< the extension that defines it; none for a motor
  xml::ElementId command = xml::kNoElement;  ///< its <command_interface>, if it has one
  std::optional<double> effort, speed;       ///< largest value; N m or N, rad/s or m/s; above 0
  std::optional<double> least_effort;        ///< none: that in the other direction; N m or N
  std::optional<double> lower, upper;        ///< limits of the position, rad or m
  double gain = 0;                           ///< gain of a position, 1/s
  /// That the caller, the motor or the controller asks for.
  std::optional<double> kp, kv, armature;
  bool has_followers = false;                   ///< other joints mimic it
  const ControlledJoint* controller = nullptr;  ///< that decided about the kind; may be null
  bool has_gains_of_controller = false;         ///< `kp` is that of the controller
  bool has_own_gains = false;  ///< the motor states its law: `kv`, and `kp` if it has one
};

/// "as `arm_controller` commands, from config/controllers.yaml": for the result, which does not
/// name folders of this machine.
std::string origin_of(const ControlledJoint& joint);

/// Whether a joint that mimics another can have a drive: in MuJoCo, which holds the two together
/// softly, both can push. Then it has that of its motor, unless that is a servo with chosen gains
/// beside a driven leader, which it would work against.
enum class FollowerDrives : bool { none, as_written };

/// One drive per joint, in the order of the model, for joints with one axis.
std::vector<JointDrive> joint_drives(const LinkedModel& model, const MotorOptions& options = {},
                                     FollowerDrives followers = FollowerDrives::none);

/// The numbers of a motor: its force is kp (command - position) - kv speed, within its effort; that
/// of an effort is the command. N m/rad and N m s/rad, or N/m and N s/m.
struct DriveGains {
  double kp = 0, kv = 0;
  double damping = 0;       ///< of the joint, besides what the URDF says; not within the effort
  double armature = 0;      ///< of the joint, kg m^2 or kg
  bool is_bounded = false;  ///< other gains than the controller states
};
/// How strongly a motor resists a wrong speed. MARS's motors reach their speed within a step; these
/// use their full effort at a difference of a tenth of the largest speed.
DriveGains gains_of(const JointDrive& drive);
/// The same, stable in steps of this length and of twice it, in a simulator that integrates the
/// damping of joints implicitly, and the force of a motor explicitly while it is at its limit. A
/// motor that states its law keeps it.
DriveGains gains_of(const JointDrive& drive, const JointInertia& inertia, double step);

/// By joint: the armatures that joints have in annotations, without those of motors; kg m^2 or kg.
/// The first entry of a joint counts.
std::map<std::string_view, double> armatures_of(const LinkedModel& model);

/// A motor that makes its joint follow another joint.
struct DrivenFollower {
  const urdf::Joint* joint = nullptr;
  const urdf::Joint* leader = nullptr;
  double multiplier = 0, offset = 0;
};
/// The followers among joints without a mimic element.
std::vector<DrivenFollower> driven_followers(const LinkedModel& model);

/// Motors that move no joint, either directly or by following another motor.
std::vector<const Motor*> idle_motors(const LinkedModel& model, FollowerDrives followers);

}  // namespace smurf
