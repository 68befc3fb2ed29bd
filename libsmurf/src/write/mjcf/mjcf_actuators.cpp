// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf/mjcf_actuators.hpp"

#include "base/numbers/numbers.hpp"

namespace smurf {
namespace {

std::string around_zero(double most) { return join_numbers({-most, most}); }

}  // namespace

void MjcfActuators::add_actuators() {
  bool is_open = false;
  std::map<const LinkedModel*, std::vector<JointDrive>> drives;
  for (std::size_t i = 0; i < count(); ++i) {
    const LinkedModel* model = robot_of(i);
    if (model == nullptr || !flat(i).X_WE) continue;
    const auto [known, is_new] = drives.try_emplace(model);
    if (is_new) known->second = joint_drives(*model);
    for (const JointDrive& drive : known->second) {
      if (!is_open) xml_.open("actuator");
      is_open = true;
      add_actuator(i, drive);
    }
  }
  if (is_open) xml_.close();
}

void MjcfActuators::add_actuator(std::size_t i, const JointDrive& drive) {
  std::vector<XmlText::Attribute> actuator{{"name", name(i, drive.name)},
                                           {"joint", name(i, *drive.joint->name)}};
  const auto limit = [&](std::string_view what, std::string_view range, std::string numbers) {
    actuator.emplace_back(what, "true");
    actuator.emplace_back(range, std::move(numbers));
  };
  double command = 0;
  if (drive.kind == DriveKind::effort) {
    if (drive.effort) limit("ctrllimited", "ctrlrange", around_zero(*drive.effort));
    xml_.empty("motor", actuator);
  } else {
    const double kv = speed_gain(drive);
    const bool is_position = drive.kind == DriveKind::position;
    const double kp = is_position ? drive.gain * kv : 0;
    actuator.emplace_back("biastype", "affine");
    actuator.emplace_back("gainprm", format_number(is_position ? kp : kv));
    actuator.emplace_back("biasprm", join_numbers({0, -kp, -kv}));
    if (is_position) {
      const LinkedModel& model = *robot_of(i);
      command = start_position(model, *drive.joint, scene_.joint_positions(i));
      if (drive.lower && drive.upper && *drive.lower < *drive.upper) {
        limit("ctrllimited", "ctrlrange", join_numbers({*drive.lower, *drive.upper}));
      }
    } else if (drive.speed) {
      limit("ctrllimited", "ctrlrange", around_zero(*drive.speed));
    }
    if (drive.effort) limit("forcelimited", "forcerange", around_zero(*drive.effort));
    xml_.empty("general", actuator);
  }
  commands_ += (commands_.empty() ? "" : " ") + format_number(command);
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
