// SPDX-License-Identifier: BSD-3-Clause
// What moves the joints of a model: SMURF motors, else ros2_control, else transmissions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// The quantity that is commanded.
enum class DriveKind : std::uint8_t { position, velocity, effort };

struct JointDrive {
  const urdf::Joint* joint = nullptr;
  DriveKind kind = DriveKind::position;
  std::string name;                          ///< of the motor; else that of the joint
  xml::ElementId element = xml::kNoElement;  ///< the extension that says so; none for a motor
  std::optional<double> effort, speed;       ///< largest; N m or N, rad/s or m/s; above 0
  std::optional<double> lower, upper;        ///< of the position, rad or m
  double gain = 0;                           ///< of a position, 1/s
};

/// One drive per joint, in the order of the model, for joints with one axis that do not mimic
/// another joint.
std::vector<JointDrive> joint_drives(const LinkedModel& model);

/// How strongly a motor resists a wrong speed, N m s/rad or N s/m. MARS's motors reach their speed
/// within a step; these give all they have when they are a tenth of the largest speed off.
double speed_gain(const JointDrive& drive);

/// A motor that makes its joint follow another joint.
struct DrivenFollower {
  const urdf::Joint* joint = nullptr;
  const urdf::Joint* leader = nullptr;
  double multiplier = 0, offset = 0;
};
/// The followers among joints without a mimic element.
std::vector<DrivenFollower> driven_followers(const LinkedModel& model);

/// Motors that move no joint, neither by themselves nor by following another motor.
std::vector<const Motor*> idle_motors(const LinkedModel& model);

}  // namespace smurf
