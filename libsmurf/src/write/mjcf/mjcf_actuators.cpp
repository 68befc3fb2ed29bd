// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf/mjcf_actuators.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers/numbers.hpp"
#include "base/numbers/vectors.hpp"
#include "write/parts/body_inertia.hpp"
#include "write/parts/joint_chain.hpp"

namespace smurf {
namespace {

/// Whether the body of a link has a mass in the result: its own, or the one that MuJoCo needs where
/// something moves.
bool has_mass(const LinkedModel& model, std::size_t link, bool is_free) {
  if (inertial_of(model.robot->links[link])) return true;
  const std::optional<JointIndex> above = model.tree.parent_joint[link];
  const bool moves = above ? model.joint(*above).has_one_axis() : is_free;
  return moves && !carries_mass(model, link);
}

std::string around_zero(double most) { return join_numbers({-most, most}); }

std::string efforts_of(const JointDrive& drive) {
  return join_numbers({drive.least_effort.value_or(-*drive.effort), *drive.effort});
}

}  // namespace

const std::vector<MjcfActuators::Motor>& MjcfActuators::motors_of(std::size_t i) {
  const LinkedModel& model = *robot_of(i);
  const bool is_free = flat(i).anchor.kind == Attachment::Kind::none;
  const auto [known, is_new] = motors_.try_emplace({&model, flat(i).joint_pose, is_free});
  if (!is_new) return known->second;
  const std::vector<JointDrive> drives =
      joint_drives(model, scene_.motors, FollowerDrives::as_written);
  if (drives.empty()) return known->second;
  std::vector<std::optional<LinkInertial>> masses(model.robot->links.size());
  for (std::size_t link = 0; link < masses.size(); ++link) {
    if (has_mass(model, link, is_free)) {
      masses[link] = link_mass(scene_, model, model.robot->links[link]).mass;
    }
  }
  const Vector3 gravity = scene_.flat.physics.gravity.value_or(kUsualGravity);
  const std::vector<std::optional<Pose>>& poses = frames_of(scene_, i, frames_);
  const std::vector<JointInertia> inertias =
      joint_inertias(model, poses, masses, is_free, std::sqrt(dot(gravity, gravity)));
  const double step = scene_.flat.physics.step_size.value_or(kUsualStep);
  for (const JointDrive& drive : drives) {
    const auto joint = static_cast<std::size_t>(drive.joint - model.robot->joints.data());
    // MuJoCo refuses a motor of a joint that is not there: the root does not reach it.
    const auto link = carried_link(model, joint);
    if (!link || !poses[*link]) continue;
    const Motor& motor =
        known->second.emplace_back(Motor{drive, smurf::gains_of(drive, inertias[joint], step)});
    if (motor.gains.is_bounded) losses_.note(kBoundedGains, drive.joint->span, *drive.joint->name);
  }
  return known->second;
}

DriveGains MjcfActuators::gains_of(std::size_t i, const urdf::Joint& joint) {
  const std::vector<Motor>& motors = motors_of(i);
  // Motors are in the order of the joints.
  const auto found = std::lower_bound(
      motors.begin(), motors.end(), &joint,
      [](const Motor& motor, const urdf::Joint* one) { return motor.drive.joint < one; });
  return found != motors.end() && found->drive.joint == &joint ? found->gains : DriveGains();
}

void MjcfActuators::add_actuators() {
  bool is_open = false;
  for (std::size_t i = 0; i < count(); ++i) {
    if (robot_of(i) == nullptr || !flat(i).X_WE) continue;
    const ControlledJoint* last = nullptr;
    for (const Motor& motor : motors_of(i)) {
      if (!is_open) xml_.open("actuator");
      is_open = true;
      const ControlledJoint* controller = motor.drive.controller;
      const bool is_same = controller == last || (controller != nullptr && last != nullptr &&
                                                  controller->controller == last->controller);
      if (!is_same) {
        xml_.comment(controller == nullptr ? "without controller" : origin_of(*controller));
      }
      last = controller;
      add_actuator(i, motor);
    }
  }
  if (is_open) xml_.close();
}

void MjcfActuators::add_actuator(std::size_t i, const Motor& motor) {
  const auto& [drive, gains] = motor;
  std::vector<XmlText::Attribute> actuator{{"name", name(i, drive.name)},
                                           {"joint", name(i, *drive.joint->name)}};
  const auto limit = [&](std::string_view what, std::string_view range, std::string numbers) {
    actuator.emplace_back(what, "true");
    actuator.emplace_back(range, std::move(numbers));
  };
  double command = 0;
  const urdf::Joint* placed = nullptr;
  if (drive.kind == DriveKind::effort) {
    if (drive.effort) limit("ctrllimited", "ctrlrange", efforts_of(drive));
    xml_.empty("motor", actuator);
  } else {
    const bool is_position = drive.kind == DriveKind::position;
    actuator.emplace_back("biastype", "affine");
    actuator.emplace_back("gainprm", format_number(is_position ? gains.kp : gains.kv));
    actuator.emplace_back("biasprm", join_numbers({0, -gains.kp, -gains.kv}));
    if (is_position) {
      placed = drive.joint;
      command = start_of(i, *placed);
      if (drive.lower && drive.upper && *drive.lower < *drive.upper) {
        limit("ctrllimited", "ctrlrange", join_numbers({*drive.lower, *drive.upper}));
      }
    } else if (drive.speed) {
      limit("ctrllimited", "ctrlrange", around_zero(*drive.speed));
    }
    if (drive.effort) limit("forcelimited", "forcerange", efforts_of(drive));
    xml_.empty("general", actuator);
  }
  keys_.add_command(i, placed, command);
}

void MjcfActuators::append_driven_followers(std::vector<MjcfFollower>& followers) const {
  for (std::size_t i = 0; i < count(); ++i) {
    const LinkedModel* model = robot_of(i);
    if (model == nullptr || !flat(i).X_WE || model->annotations.motors.empty()) continue;
    for (const DrivenFollower& follower : driven_followers(*model)) {
      if (!follower.joint->name || !follower.leader->name) continue;
      followers.push_back({name(i, *follower.joint->name), name(i, *follower.leader->name),
                           follower.offset, follower.multiplier});
    }
  }
}

}  // namespace smurf
