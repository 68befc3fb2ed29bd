// SPDX-License-Identifier: BSD-3-Clause
// Transmissions (ros_control, PR2) and ros2_control become motors. A motor has the name of its
// joint: MARS finds the joints of a pose by motor names, Phobos by joint names.
#include <numbers>

#include "convert/import.hpp"
#include "convert/joint_commands.hpp"

namespace smurf::import {
namespace {

/// How a joint is driven, and the element that states it.
struct Drive {
  std::string type;  ///< of the motor
  std::string comment;
  std::optional<double> lowest, highest;  ///< commanded position
  std::optional<double> speed, effort;
};

/// Drives by joint; if several elements drive a joint, the first one applies.
using Drives = std::vector<std::optional<Drive>>;

/// "hardware_interface/EffortJointInterface", "effort".
std::string motor_type(std::string_view interface) {
  const auto names = [&](std::string_view upper, std::string_view lower) {
    return interface.find(upper) != std::string_view::npos || interface == lower;
  };
  if (names("Position", "position")) return "PID";
  if (names("Velocity", "velocity")) return "DC";
  if (names("Effort", "effort")) return "direct_effort";
  return {};
}

class MotorMaker {
 public:
  explicit MotorMaker(Context& context) : context_(context) {
    drives_.resize(context.robot().joints.size());
  }

  std::vector<NewValue> make() {
    if (context_.options.motors == MotorChoice::none) return {};
    for (const xml::View element : extensions_of(context_, "ros2_control")) ros2_control(element);
    for (const xml::View element : extensions_of(context_, "transmission")) transmission(element);
    if (context_.options.motors == MotorChoice::all) every_joint();
    follow_mimics();
    std::vector<NewValue> motors;
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      if (drives_[i]) motors.push_back(motor(context_.robot().joints[i], *drives_[i]));
    }
    return motors;
  }

 private:
  std::optional<std::uint32_t> joint_index(xml::View element) const {
    const auto index = context_.model.joint_names.find(attribute_of(element, "name"));
    if (!index || !context_.robot().joints[*index].has_one_axis()) return std::nullopt;
    return index;
  }

  void ros2_control(xml::View system) {
    for (const xml::View joint : system) {
      const auto index = joint.name() == "joint" ? joint_index(joint) : std::nullopt;
      if (!index || drives_[*index]) continue;
      const std::optional<JointCommand> command = joint_command(joint);
      if (!command) continue;  // only observed
      Drive drive{.type = motor_type(command->interface),
                  .comment = {},
                  .lowest = command->position_lower,
                  .highest = command->position_upper,
                  .speed = command->speed,
                  .effort = command->effort};
      drive.comment = "from ros2_control, " + context_.line_of(joint.span());
      drives_[*index] = drive;
    }
  }

  void transmission(xml::View element) {
    std::vector<xml::View> joints;
    for (const xml::View child : element) {
      if (child.name() == "joint") joints.push_back(child);
    }
    std::string_view type = child_text(element, "type");
    if (type.empty()) type = attribute_of(element, "type");
    const std::string what =
        "the transmission `" + std::string(attribute_of(element, "name")) + "`";
    if (type.find("SimpleTransmission") == std::string_view::npos || joints.size() != 1) {
      context_.keep_as_text(element.name_span(), what, "a SMURF motor drives one joint directly");
      return;
    }
    const auto index = joint_index(joints.front());
    if (!index) {
      context_.keep_as_text(element.name_span(), what, "its joint has no axis or is unknown");
      return;
    }
    const std::optional<std::string_view> interface = transmission_interface(element);
    if (!interface || drives_[*index]) return;
    Drive drive;
    drive.type = motor_type(*interface);
    drive.comment = "from a transmission, " + context_.line_of(element.span());
    if (drive.type.empty()) {
      drive.type = "PID";
      drive.comment += "; it does not say how the joint is commanded";
    }
    drives_[*index] = drive;
  }

  void every_joint() {
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      const urdf::Joint& joint = context_.robot().joints[i];
      if (drives_[i] || !joint.name || !joint.has_one_axis() || joint.mimic) continue;
      drives_[i] = Drive{"PID", "from the joint, " + context_.line_of(joint.span), {}, {}, {}, {}};
    }
  }

  /// MARS does not read <mimic>, so a joint that follows a driven joint needs a motor.
  void follow_mimics() {
    std::vector<std::vector<std::size_t>> followers(drives_.size());
    std::vector<std::size_t> driven;
    for (std::size_t i = 0; i < drives_.size(); ++i) {
      if (drives_[i]) driven.push_back(i);
      const urdf::Joint& joint = context_.robot().joints[i];
      if (!joint.name || !joint.has_one_axis() || !joint.mimic || !joint.mimic->joint) continue;
      const auto leader = context_.model.joint_names.find(*joint.mimic->joint);
      if (leader) followers[*leader].push_back(i);
    }
    while (!driven.empty()) {
      const std::size_t leader = driven.back();
      driven.pop_back();
      for (const std::size_t i : followers[leader]) {
        if (drives_[i]) continue;
        const urdf::Joint& joint = context_.robot().joints[i];
        drives_[i] =
            Drive{"PID", "from <mimic>, " + context_.line_of(joint.mimic->span), {}, {}, {}, {}};
        driven.push_back(i);
      }
    }
  }

  NewValue motor(const urdf::Joint& joint, const Drive& drive) const {
    NewValue entry =
        mapping_value({}, {text_value("name", *joint.name), text_value("joint", *joint.name),
                           text_value("type", drive.type)});
    entry.comment = drive.comment;
    auto& keys = entry.children;
    if (drive.type == "PID") {
      keys.push_back(number_value("p", 10, "not in the URDF: speed per error, 1/s"));
      keys.push_back(number_value("i", 0));
      keys.push_back(number_value("d", 0));
    }
    const urdf::Limit limit = joint.limit.value_or(urdf::Limit{});
    add_range(joint, limit, drive, keys);
    add_bound("maxEffort", limit.effort, drive.effort, keys);
    add_bound("maxSpeed", limit.velocity, drive.speed, keys);
    add_mimic(joint, keys);
    return entry;
  }

  /// ros2_control may narrow the range of the joint, never widen it.
  static void add_range(const urdf::Joint& joint, const urdf::Limit& limit, const Drive& drive,
                        std::vector<NewValue>& keys) {
    std::optional<double> low = limit.lower.value();
    std::optional<double> high = limit.upper.value();
    if (joint.type == urdf::JointType::continuous) {
      low = -std::numbers::pi;
      high = std::numbers::pi;
    }
    // The default of the format is a full turn, but absent bounds in a URDF are 0.
    const double joint_low = low.value_or(0);
    const double joint_high = high.value_or(0);
    if (drive.lowest && (!low || *drive.lowest > *low)) low = drive.lowest;
    if (drive.highest && (!high || *drive.highest < *high)) high = drive.highest;
    const bool is_empty = low.value_or(0) > high.value_or(0);
    const double min = is_empty ? joint_low : low.value_or(0);
    const double max = is_empty ? joint_high : high.value_or(0);
    if (min > max) return;  // a motor with this range is an error
    keys.push_back(number_value("minValue", min));
    keys.push_back(number_value("maxValue", max));
  }

  static void add_bound(const char* key, const Field<double>& of_joint,
                        const std::optional<double>& of_drive, std::vector<NewValue>& keys) {
    std::optional<double> bound = of_joint.value();
    if (of_drive && *of_drive > 0 && (!bound || *of_drive < *bound)) bound = of_drive;
    if (bound && *bound >= 0) keys.push_back(number_value(key, *bound));
  }

  void add_mimic(const urdf::Joint& joint, std::vector<NewValue>& keys) const {
    if (!joint.mimic || !joint.mimic->joint) return;
    const auto leader = context_.model.joint_names.find(*joint.mimic->joint);
    if (!leader || !drives_[*leader]) return;
    keys.push_back(text_value("mimic_motor", *joint.mimic->joint));
    keys.push_back(number_value("mimic_multiplier", joint.mimic->multiplier.value_or(1)));
    keys.push_back(number_value("mimic_offset", joint.mimic->offset.value_or(0)));
  }

  Context& context_;
  Drives drives_;
};

}  // namespace

Part motors(Context& context) {
  std::vector<NewValue> entries = MotorMaker(context).make();
  if (entries.empty()) return std::nullopt;
  return NewFile{"motors", "motors; limits are those of the joints: rad, rad/s, N m, or m, m/s, N",
                 list_value("motors", std::move(entries))};
}

}  // namespace smurf::import
