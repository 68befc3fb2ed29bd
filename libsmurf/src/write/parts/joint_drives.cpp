// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/joint_drives.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"
#include "base/text/quoted.hpp"
#include "base/text/wildcards.hpp"
#include "convert/annotation_values.hpp"
#include "convert/import.hpp"
#include "convert/joint_commands.hpp"
#include "convert/passes.hpp"

namespace smurf {
namespace {

/// A limit that is too large for computations is treated as absent; SDF writes such a one for none.
std::optional<double> above_zero(std::optional<double> value) {
  constexpr double kNone = 1e16;
  return value && *value > 0 && *value < kNone ? value : std::nullopt;
}

DriveKind kind_of(std::string_view interface) {
  if (interface.find("osition") != std::string_view::npos) return DriveKind::position;
  if (interface.find("elocity") != std::string_view::npos) return DriveKind::velocity;
  return DriveKind::effort;
}

/// A number of an annotation that only simulators read.
std::optional<double> stated_number(const LinkedModel& model, const Annotation& one,
                                    std::string_view key) {
  const yaml::Document* document = model.document(one.span.source);
  if (document == nullptr) return std::nullopt;
  const yaml::View value = yaml::View(*document, one.node).find(key);
  const auto number = value ? value.number() : std::nullopt;
  return number && is_quantity(*number) ? number : std::nullopt;
}

/// The same if it is not negative.
std::optional<double> stated(const LinkedModel& model, const Annotation& one,
                             std::string_view key) {
  const auto number = stated_number(model, one, key);
  return number && *number >= 0 ? number : std::nullopt;
}

class DriveReader {
 public:
  DriveReader(const LinkedModel& model, const MotorOptions& options, FollowerDrives followers)
      : model_(model),
        options_(options),
        followers_(followers),
        drives_(model.robot->joints.size()) {
    const auto controlled = options.controlled.find(&model);
    if (controlled != options.controlled.end()) controlled_ = &controlled->second;
  }

  std::vector<JointDrive> read() {
    const AnnotationValues values(model_);
    for (const Motor& motor : model_.annotations.motors) {
      if (!motor.mimic_motor) of_motor(motor, values.joint_of(motor));
    }
    of_extensions("ros2_control", &DriveReader::of_ros2_control);
    of_extensions("transmission", &DriveReader::of_transmission);
    if (controlled_ != nullptr) {
      for (const auto& [name, one] : *controlled_) drive_of(model_.find_joint(name));
    }
    if (options_.kind != MotorKind::as_written) add_missing();
    if (followers_ == FollowerDrives::as_written) add_followers(values);
    const std::set<const urdf::Joint*> leaders = leaders_of_others();
    std::vector<JointDrive> found;
    for (std::optional<JointDrive>& drive : drives_) {
      if (!drive) continue;
      apply_controller(*drive);
      apply_options(*drive);
      drive->has_followers = leaders.contains(drive->joint);
      if (!opposes_leader(*drive)) found.push_back(std::move(*drive));
    }
    return found;
  }

 private:
  /// The motors of joints that follow others.
  void add_followers(const AnnotationValues& values) {
    for (const Motor& motor : model_.annotations.motors) {
      const urdf::Joint* joint = motor.mimic_motor ? nullptr : values.joint_of(motor);
      if (joint != nullptr && joint->mimic) of_motor(motor, joint);
    }
  }

  /// Whether a servo would hold its joint elsewhere than the leader of the joint moves it.
  bool opposes_leader(const JointDrive& drive) const {
    if (!drive.joint->mimic || drive.kind == DriveKind::effort || drive.kp || drive.kv)
      return false;
    const auto& name = drive.joint->mimic->joint;
    const urdf::Joint* leader = name ? model_.find_joint(*name) : nullptr;
    if (leader == nullptr) return false;
    return drives_[static_cast<std::size_t>(leader - model_.robot->joints.data())].has_value();
  }

  /// Null if the joint is already driven, or cannot be driven.
  JointDrive* drive_of(const urdf::Joint* joint, bool is_follower = false) {
    if (joint == nullptr || !joint->has_one_axis() || !joint->name) return nullptr;
    if ((joint->mimic != nullptr) != is_follower) return nullptr;
    const auto at = static_cast<std::size_t>(joint - model_.robot->joints.data());
    if (drives_[at]) return nullptr;
    JointDrive& drive = drives_[at].emplace();
    drive.joint = joint;
    drive.name = *joint->name;
    if (joint->limit) {
      drive.effort = above_zero(joint->limit->effort.value());
      drive.speed = above_zero(joint->limit->velocity.value());
      if (joint->type != urdf::JointType::continuous) {
        drive.lower = joint->limit->lower.value_or(0);
        drive.upper = joint->limit->upper.value_or(0);
      }
    }
    // Phobos gives its motors this gain (representation.py).
    constexpr double kUsualGain = 20;
    drive.gain = kUsualGain;
    return &drive;
  }

  std::set<const urdf::Joint*> leaders_of_others() const {
    std::set<const urdf::Joint*> leaders;
    for (const urdf::Joint& joint : model_.robot->joints) {
      if (joint.mimic && joint.mimic->joint) {
        leaders.insert(model_.find_joint(*joint.mimic->joint));
      }
    }
    for (const DrivenFollower& follower : driven_followers(model_)) leaders.insert(follower.leader);
    return leaders;
  }

  /// A joint that no followed motor moves either.
  void add_missing() {
    std::set<const urdf::Joint*> followers;
    for (const DrivenFollower& follower : driven_followers(model_)) {
      followers.insert(follower.joint);
    }
    for (const urdf::Joint& joint : model_.robot->joints) {
      if (!followers.contains(&joint)) drive_of(&joint);
    }
  }

  /// Null if no controller commands the joint.
  const ControlledJoint* controlled(std::string_view joint) const {
    if (controlled_ == nullptr) return nullptr;
    const auto found = controlled_->find(joint);
    return found == controlled_->end() ? nullptr : &found->second;
  }

  void apply_controller(JointDrive& drive) const {
    const ControlledJoint* controller = controlled(*drive.joint->name);
    if (controller == nullptr) return;
    drive.controller = controller;
    drive.kind = controller->kind == MotorKind::velocity ? DriveKind::velocity
                 : controller->kind == MotorKind::effort ? DriveKind::effort
                                                         : DriveKind::position;
    if (controller->kp) drive.kp = controller->kp;
    if (controller->kv) drive.kv = controller->kv;
    if (controller->kp || controller->kv) drive.has_own_gains = false;
    drive.has_gains_of_controller = controller->kp.has_value();
  }

  void apply_options(JointDrive& drive) const {
    switch (options_.kind) {
    case MotorKind::as_written: break;
    case MotorKind::automatic:
      // A program commands the effort so that the joint gets to a position, unless its controller
      // is known and has no gains.
      if (drive.kind == DriveKind::effort && drive.controller == nullptr) {
        drive.kind = DriveKind::position;
      }
      break;
    case MotorKind::position: drive.kind = DriveKind::position; break;
    case MotorKind::velocity: drive.kind = DriveKind::velocity; break;
    case MotorKind::effort: drive.kind = DriveKind::effort; break;
    }
    const std::string& joint = *drive.joint->name;
    if (const auto kp = number_for(options_.kp, joint)) {
      drive.kp = kp;
      drive.has_gains_of_controller = drive.has_own_gains = false;
    }
    if (const auto kv = number_for(options_.kv, joint)) {
      drive.kv = kv;
      drive.has_own_gains = false;
    }
    if (drive.kind == DriveKind::position && !drive.kp) drive.has_own_gains = false;
    if (const auto armature = number_for(options_.armature, joint)) drive.armature = armature;
  }

  /// The last pattern that fits decides.
  static std::optional<double> number_for(const std::vector<JointNumber>& numbers,
                                          std::string_view joint) {
    std::optional<double> found;
    for (const JointNumber& number : numbers) {
      if (number.joints.empty() || matches(joint, number.joints)) found = number.value;
    }
    return found;
  }

  const urdf::Joint* joint_named(xml::View element) const {
    return model_.find_joint(attribute_of(element, "name"));
  }

  void of_motor(const Motor& motor, const urdf::Joint* joint) {
    const bool is_follower =
        followers_ == FollowerDrives::as_written && joint != nullptr && joint->mimic;
    JointDrive* drive = drive_of(joint, is_follower);
    if (drive == nullptr) return;
    drive->motor = &motor;
    if (motor.name) drive->name = *motor.name;
    drive->kind = kind_of(passes::interface_of(motor));
    if (const auto effort = above_zero(limit_of(motor, LimitValue::effort))) drive->effort = effort;
    if (const auto speed = above_zero(limit_of(motor, LimitValue::velocity))) drive->speed = speed;
    const auto lower = limit_of(motor, LimitValue::lower);
    const auto upper = limit_of(motor, LimitValue::upper);
    drive->gain = above_zero(motor.p.value()).value_or(drive->gain);
    drive->kp = stated(model_, motor, "kp");
    drive->kv = stated(model_, motor, "kv");
    drive->armature = stated(model_, motor, "armature");
    drive->has_own_gains = drive->kv && (drive->kp || drive->kind == DriveKind::velocity);
    // A motor that states its law may be commanded beyond the limits of its joint.
    const bool is_ranged = lower && upper && *lower < *upper;
    if (is_ranged || drive->has_own_gains) {
      drive->lower = is_ranged ? lower : std::nullopt;
      drive->upper = is_ranged ? upper : std::nullopt;
    }
    if (drive->effort) drive->least_effort = least_effort_of(motor, *drive);
  }

  /// None if a motor pushes in both directions equally.
  std::optional<double> least_effort_of(const Motor& motor, const JointDrive& drive) const {
    const auto least = stated_number(model_, motor, "minEffort");
    constexpr double kNone = 1e16;
    const bool is_used = least && std::fabs(*least) < kNone && *least < *drive.effort;
    return is_used ? least : std::nullopt;
  }

  void of_extensions(std::string_view name, void (DriveReader::*take)(xml::View)) {
    for (const xml::ElementId id : model_.robot->extensions) {
      const xml::View element(model_.robot->document, id);
      if (element.name() == name) (this->*take)(element);
    }
  }

  void of_ros2_control(xml::View system) {
    for (const xml::View joint : system) {
      if (joint.name() != "joint") continue;
      const std::optional<JointCommand> command = joint_command(joint, claimed_interface(joint));
      if (!command) continue;
      JointDrive* drive = add(system, joint_named(joint), command->interface);
      if (drive == nullptr) continue;
      drive->command = command->element.id();
      narrow(*drive, *command);
    }
  }

  /// The interface that a controller claims of a joint of ros2_control; "" if none does.
  std::string_view claimed_interface(xml::View joint) const {
    const ControlledJoint* controller = controlled(attribute_of(joint, "name"));
    if (controller == nullptr) return {};
    if (controller->kp || controller->kv || controller->kind == MotorKind::effort) return "effort";
    return controller->kind == MotorKind::velocity ? "velocity" : "position";
  }

  /// The limits of a command may narrow those of the joint, never widen them.
  static void narrow(JointDrive& drive, const JointCommand& command) {
    const auto least = [](std::optional<double>& limit, std::optional<double> other) {
      other = above_zero(other);
      if (other && (!limit || *other < *limit)) limit = other;
    };
    least(drive.speed, command.speed);
    least(drive.effort, command.effort);
    const std::optional<double>& lower = command.position_lower;
    const std::optional<double>& upper = command.position_upper;
    if (!lower || !upper || !is_quantity(*lower) || !is_quantity(*upper)) return;
    const double low = std::max(*lower, drive.lower.value_or(*lower));
    const double high = std::min(*upper, drive.upper.value_or(*upper));
    if (!(low < high)) return;
    drive.lower = low;
    drive.upper = high;
  }

  void of_transmission(xml::View transmission) {
    const xml::View joint = transmission.child("joint");
    std::string_view type = import::child_text(transmission, "type");
    if (type.empty()) type = attribute_of(transmission, "type");
    if (!joint || type.find("SimpleTransmission") == std::string_view::npos) return;
    const std::optional<std::string_view> interface = transmission_interface(transmission);
    // A position, as for urdf2smurf, if it does not state how the joint is commanded.
    if (interface) {
      add(transmission, joint_named(joint), interface->empty() ? "position" : *interface);
    }
  }

  JointDrive* add(xml::View element, const urdf::Joint* joint, std::string_view interface) {
    JointDrive* drive = drive_of(joint);
    if (drive == nullptr) return nullptr;
    drive->kind = kind_of(interface);
    drive->element = element.id();
    return drive;
  }

  const LinkedModel& model_;
  const MotorOptions& options_;
  FollowerDrives followers_;
  const ControlledJoints* controlled_ = nullptr;   ///< null: no controller commands the model
  std::vector<std::optional<JointDrive>> drives_;  ///< by joint
};

}  // namespace

std::string origin_of(const ControlledJoint& joint) {
  const std::string_view folder = path::file_name(path::parent(joint.file));
  const bool has_name = !folder.empty() && folder.front() != '.';
  return "as " + quoted(joint.controller) + " commands, from " +
         (has_name ? std::string(folder) + "/" : "") + std::string(path::file_name(joint.file));
}

std::vector<JointDrive> joint_drives(const LinkedModel& model, const MotorOptions& options,
                                     FollowerDrives followers) {
  return model.robot ? DriveReader(model, options, followers).read() : std::vector<JointDrive>();
}

std::map<std::string_view, double> armatures_of(const LinkedModel& model) {
  std::map<std::string_view, double> armatures;
  for (const JointAnnotation& one : model.annotations.joints) {
    if (one.name) armatures.emplace(*one.name, stated(model, one, "armature").value_or(0));
  }
  return armatures;
}

DriveGains gains_of(const JointDrive& drive) {
  DriveGains gains;
  gains.armature = drive.armature.value_or(0);
  if (drive.kind == DriveKind::effort) return gains;
  constexpr double kWithoutLimits = 100;
  const double kv =
      drive.effort && drive.speed ? 10 * *drive.effort / *drive.speed : kWithoutLimits;
  gains.kv = drive.kv.value_or(is_quantity(kv) ? kv : kWithoutLimits);
  if (drive.kind != DriveKind::position) return gains;
  gains.kp = drive.kp.value_or(drive.gain * gains.kv);
  // A stated stiffness alone gets the damping at which its joint does not swing.
  if (drive.kp && !drive.kv) gains.kv = *drive.kp / drive.gain;
  return gains;
}

namespace {

/// 0.3 rad, or a tenth of the range: what a motor is asked for.
double way_of(const JointDrive& drive) {
  constexpr double kWay = 0.3;
  if (!drive.lower || !drive.upper || !(*drive.lower < *drive.upper)) return kWay;
  const double tenth = 0.1 * (*drive.upper - *drive.lower);
  return drive.joint->type == urdf::JointType::prismatic ? tenth : std::min(kWay, tenth);
}

constexpr double kSlowest = 0.2;  // s, of kv/kp; in ten times of it, a joint has arrived

/// What holds the weight of all that a joint carries, and its friction, to 1.5 % of this way, and
/// arrives in time against its inertia and the damping of the URDF.
double least_stiffness(const JointDrive& drive, const JointInertia& inertia, double moved) {
  constexpr double kSag = 0.015;
  constexpr double kSlowestRate = 5;  // rad/s: with good damping, 2 % remain after 1.1 s
  const auto& dynamics = drive.joint->dynamics;
  const double friction = dynamics ? dynamics->friction.value_or(0) : 0;
  const double damping = dynamics ? dynamics->damping.value_or(0) : 0;
  return std::max({(inertia.gravity + std::max(friction, 0.0)) / (kSag * way_of(drive)),
                   damping / kSlowest, kSlowestRate * kSlowestRate * moved});
}

/// The damping at which a joint hardly swings that asks for more than its effort: it must begin to
/// brake half of the way before it arrives, and still be there in time.
double damping_for(double kp, double moved, const JointDrive& drive) {
  constexpr double kRatio = 0.7;
  const double linear = 2 * kRatio * std::sqrt(kp * moved);
  const double braking =
      drive.effort ? kp * std::sqrt(way_of(drive) * moved / *drive.effort) / 2 : 0;
  return std::min(std::max(linear, braking), kSlowest * kp);
}

/// Keeps the gains of a controller where a motor of a simulator works with them. The controller may
/// have an integral part against the weight, and its damping is about the difference from the speed
/// of a trajectory: a motor has neither.
void bound(DriveGains& gains, const JointDrive& drive, const JointInertia& inertia, double step) {
  const DriveGains stated = gains;
  const double moved = inertia.locked + gains.armature;
  const double free = inertia.free + gains.armature;
  // The force of a motor is integrated explicitly: at twice the step, a spring moves its joint by
  // at most the whole error in one step.
  if (free > 0) gains.kp = std::min(gains.kp, free / (4 * step * step));
  gains.kp = std::max(gains.kp, least_stiffness(drive, inertia, moved));
  // With less, swinging around the goal takes more than 2 s to decay to 2 %.
  constexpr double kSlowestDecay = 4;  // 1/s
  constexpr double kLeastRatio = 0.1;  // of the damping at which it just does not swing
  const double wanted = damping_for(gains.kp, moved, drive);
  const double least =
      std::max(kSlowestDecay * moved, 2 * kLeastRatio * std::sqrt(gains.kp * moved));
  if (gains.kv < std::min(wanted, least)) gains.kv = wanted;
  gains.kv = std::min(gains.kv, kSlowest * gains.kp);
  gains.is_bounded = gains.kp != stated.kp || gains.kv != stated.kv;
}

}  // namespace

DriveGains gains_of(const JointDrive& drive, const JointInertia& inertia, double step) {
  DriveGains gains = gains_of(drive);
  // MuJoCo takes an acceleration of 1e10 for a failure. Placeholders of masses, such as 1 mg, have
  // so little inertia.
  constexpr double kMostAcceleration = 1e9;  // rad/s^2 or m/s^2
  const double least_inertia = drive.effort.value_or(0) / kMostAcceleration;
  if (!drive.armature && inertia.free < least_inertia) {
    gains.armature = least_inertia - inertia.free;
  }
  if (drive.has_own_gains) return gains;
  const bool is_of_controller = drive.kind == DriveKind::position && drive.has_gains_of_controller;
  if (is_of_controller) bound(gains, drive, inertia, step);
  const bool is_chosen = drive.kind == DriveKind::position && !drive.kp && !drive.kv;
  const double moved = inertia.locked + gains.armature;
  const double least_kp = is_chosen ? least_stiffness(drive, inertia, moved) : 0;
  if (gains.kp < least_kp) {
    gains.kp = least_kp;
    gains.kv = std::max(gains.kv, damping_for(gains.kp, moved, drive));
  }
  const double free = inertia.free + gains.armature;
  // The speed that a motor has to correct is gone after four steps, or two of twice the length.
  const double most = free / (4 * step);
  if (drive.kind == DriveKind::effort || gains.kv <= most) return gains;
  const bool has_limits = drive.effort && drive.speed;
  if (!has_limits && is_chosen) {
    // Without limits, 100 says nothing about a joint so light: 20 rad/s without swinging, or what
    // holds its weight.
    constexpr double kRate = 20;
    gains.kp = std::max(kRate * kRate * moved, least_kp);
    gains.kv = std::max(2 * std::sqrt(gains.kp * moved),
                        gains.kp / kRate);  // with joints that follow it
    if (gains.kv <= most) return gains;     // the rest would be a negative damping
  }
  if (!drive.effort) return gains;  // without a limit of the force, it is integrated implicitly
  // MuJoCo solves the equality of a follower without the damping, which then makes it unstable.
  if (drive.kind == DriveKind::velocity || drive.has_followers) {
    if (!drive.armature) gains.armature = 4 * step * gains.kv - inertia.free;
    return gains;
  }
  // The torque of a motor falls to zero at its largest speed.
  const double braking = drive.speed ? *drive.effort / *drive.speed : gains.kv;
  const double rest = gains.kv - most;
  gains.kv = std::min(gains.kv, most);
  const bool is_asked_for = drive.kv && !is_of_controller;
  gains.damping = is_asked_for ? rest : std::min(rest, braking);
  gains.is_bounded = gains.is_bounded || (is_of_controller && rest > 0);
  return gains;
}

std::vector<DrivenFollower> driven_followers(const LinkedModel& model) {
  std::vector<DrivenFollower> followers;
  if (!model.robot) return followers;
  const AnnotationValues values(model);
  for (const Motor& motor : model.annotations.motors) {
    const urdf::Joint* joint = motor.mimic_motor ? values.joint_of(motor) : nullptr;
    const urdf::Joint* leader = values.leader_of(motor);
    if (joint == nullptr || leader == nullptr || joint == leader || joint->mimic) continue;
    followers.push_back(
        {joint, leader, motor.mimic_multiplier.value_or(0), motor.mimic_offset.value_or(0)});
  }
  return followers;
}

std::vector<const Motor*> idle_motors(const LinkedModel& model, FollowerDrives followers) {
  std::vector<const Motor*> idle;
  if (!model.robot) return idle;
  const AnnotationValues values(model);
  std::set<const Motor*> driving;
  for (const JointDrive& drive : joint_drives(model, {}, followers)) driving.insert(drive.motor);
  for (const Motor& motor : model.annotations.motors) {
    const bool is_follower = motor.mimic_motor && values.joint_of(motor) != nullptr &&
                             values.leader_of(motor) != nullptr;
    if (!is_follower && !driving.contains(&motor)) idle.push_back(&motor);
  }
  return idle;
}

}  // namespace smurf
