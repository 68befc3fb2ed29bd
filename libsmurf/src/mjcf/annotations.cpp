// SPDX-License-Identifier: BSD-3-Clause
// Actuators as motors, sensors of joints and links, masks of contacts, and keyframes as poses: the
// parts of a model for which SMURF has a section.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "imports/traced_yaml.hpp"
#include "mjcf/measured_frames.hpp"
#include "mjcf/moved_inertia.hpp"
#include "mjcf/robot.hpp"

namespace smurf::mjcf {
namespace {

using imports::yaml_text;

const std::string kNoLimit = "1e+16";
constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();

class AnnotationWriter {
 public:
  AnnotationWriter(const Model& model, Reporter& reporter, xacro::Expansion& expansion)
      : model_(model), reporter_(reporter), yaml_(expansion), parts_(model) {
    for (const Reference& one : model.sections) {
      const bool measures =
          one.section == "sensor" && is_one_of(one.element.name(), {"accelerometer", "gyro"});
      if (measures) imus_.insert(parts_.site(one.element.attribute("site"), one.around));
    }
  }

  std::string run() {
    section("motors", "actuator", [&](const Reference& one) { actuator(one); });
    undriven();
    section("sensors", "sensor", [&](const Reference& one) { sensor(one); });
    collisions();
    tensors();
    section("poses", "keyframe", [&](const Reference& one) { keyframe(one); });
    return yaml_.take();
  }

 private:
  template <class F>
  void section(std::string_view name, std::string_view of, const F& write) {
    const std::size_t begin = yaml_.size();
    yaml_.plain(std::string(name) + ":\n");
    const std::size_t empty = yaml_.size();
    for (const Reference& one : model_.sections) {
      if (one.section == of) write(one);
    }
    if (yaml_.size() == empty) yaml_.cut(begin);
  }

  void line(std::string_view indent, std::string_view key, std::string_view text,
            const Place& place) {
    yaml_.line(indent, key, text, place);
  }

  void lost(const Reference& one, std::string what) {
    const std::string_view others = one.section == "sensor"     ? "lost sensors"
                                    : one.section == "actuator" ? "lost motors"
                                                                : "lost values";
    reporter_.lose(one.element.name_span(), std::move(what), others).help("keep the MJCF for it");
  }

  void actuator(const Reference& one) {
    const Attribute* name = one.element.attribute("joint");
    if (name == nullptr) name = one.element.attribute("jointinparent");
    if (name == nullptr) return;  // reported with its efforts
    const Joint* joint = parts_.joint(name, one.around);
    if (joint == nullptr) return;
    const Settings s = settings_of_actuator(one);
    const std::optional<Servo> servo = servo_of(s, reporter_);
    if (!servo) {
      lost(one, "SMURF has no motor like this " + quoted(one.element.name()) + ", so it is lost");
      return;
    }
    if (joint->type != Joint::Type::hinge && joint->type != Joint::Type::slide) {
      lost(one, "a motor of SMURF moves a joint with one axis, so this one is lost");
      return;
    }
    if (!driven_.insert(joint->name).second) {
      lost(one, "a joint of SMURF has one motor, so this second one is lost");
      return;
    }
    motor(one, *joint, s, *servo);
    lost_settings(one, s, *servo);
  }

  void motor(const Reference& one, const Joint& joint, const Settings& s, const Servo& servo) {
    const std::string_view kind = servo.kind;
    const bool holds = kind == "position" || kind == "intvelocity";
    const Place tag{one.element.name_span(), one.element.tag_span(), one.around.frame};
    line("- ", "name", yaml_text(joint.name), tag);
    line("  ", "joint", yaml_text(joint.name), s.place({"joint", "jointinparent"}));
    line("  ", "type", holds ? "PID" : kind == "motor" ? "direct_effort" : "DC", tag);
    // A command and a force are those of the motor, before the gear.
    const double gear = gear_of(s, reporter_);
    if (holds || kind == "velocity") {
      const double kv = damping_of(joint, s, servo, gear);
      const Place of_kv = s.place({"kv", "biasprm", "dampratio"});
      if (holds) {
        line("  ", "p", format_number(servo.kp), s.place({"kp", "gainprm"}));
        line("  ", "i", "0", tag);
        line("  ", "d", format_number(kv), of_kv);
        line("  ", "kp", format_number(gear * gear * servo.kp), s.place({"kp", "gainprm", "gear"}));
      }
      line("  ", "kv", format_number(gear * gear * kv), of_kv);
    }
    if (joint.armature > 0)
      line("  ", "armature", format_number(joint.armature), joint.settings.place({"armature"}));
    const auto range = commands_of(joint, s, gear);
    if (range && holds) {
      line("  ", "minValue", format_number((*range)[0]), s.place({"ctrlrange", "gear"}));
      line("  ", "maxValue", format_number((*range)[1]), s.place({"ctrlrange", "gear"}));
    } else if (range && kind == "velocity") {
      line("  ", "maxSpeed",
           format_number(std::max(std::fabs((*range)[0]), std::fabs((*range)[1]))),
           s.place({"ctrlrange"}));
      if ((*range)[0] != -(*range)[1])
        lost(one, "a motor of SMURF is as fast in both directions, so the smaller bound is lost");
    }
    // Readers of SMURF take what is not written as 0, and MuJoCo as no limit.
    if (kind != "motor" && !(range && kind == "velocity")) line("  ", "maxSpeed", kNoLimit, tag);
    efforts(one, joint, s);
  }

  /// Before the gear. A ratio is about the inertia that the joint moves, with all other joints
  /// free.
  double damping_of(const Joint& joint, const Settings& s, const Servo& servo, double gear) {
    if (!(servo.ratio > 0)) return servo.kv;
    if (!inertias_) inertias_.emplace(model_);
    const std::optional<double> moved = inertias_->free(joint);
    if (moved) return 2 * servo.ratio * std::sqrt(servo.kp * *moved) / std::fabs(gear);
    reporter_
        .lose(s.place({"dampratio", "biasprm"}).origin,
              "the damping that this ratio means depends on a mass that is unknown, so it is lost",
              "lost values")
        .help("write `kv`");
    return servo.kv;
  }

  /// The range of positions or speeds of the joint that a motor is commanded with.
  std::optional<std::array<double, 2>> commands_of(const Joint& joint, const Settings& s,
                                                   double gear) {
    std::array<double, 2> range{};
    const bool is_limited = s.text("ctrllimited") != "false" &&
                            s.numbers("ctrlrange", range, 2, reporter_) == 2 && range[0] < range[1];
    const double inherited = s.number("inheritrange", 0, reporter_);
    if (!is_limited && inherited > 0 && joint.range[0] < joint.range[1]) {
      const double middle = (joint.range[0] + joint.range[1]) / 2;
      const double half = inherited * (joint.range[1] - joint.range[0]) / 2;
      range = {middle - half, middle + half};
    } else if (!is_limited) {
      return std::nullopt;
    }
    for (double& bound : range) bound /= gear;
    if (gear < 0) std::swap(range[0], range[1]);
    return range;
  }

  /// The range of the force at the joint: that of the motor within that of all motors together.
  void efforts(const Reference& one, const Joint& joint, const Settings& s) {
    const Place place = s.place({"forcerange", "ctrlrange", "gear"});
    auto range = effort_range_of(s, reporter_);
    if (joint.force_range) {
      const auto& [low, high] = *joint.force_range;
      range = range ? std::array{std::max(low, (*range)[0]), std::min(high, (*range)[1])}
                    : *joint.force_range;
    }
    if (!range) return line("  ", "maxEffort", kNoLimit, place);
    const auto& [low, high] = *range;
    if (high > 0) {
      line("  ", "maxEffort", format_number(high), place);
      if (low != -high) line("  ", "minEffort", format_number(low), place);
    } else {
      line("  ", "maxEffort", format_number(std::fabs(low)), place);
      lost(one, "a motor of SMURF pushes in both directions, so a range below 0 is lost");
    }
  }

  /// What an actuator has besides its law and its ranges.
  void lost_settings(const Reference& one, const Settings& s, const Servo& servo) {
    std::vector<std::string> names;
    for (const std::string_view name : {"timeconst", "delay", "nsample", "actrange"}) {
      const Attribute* set = s.find(name);
      if (set != nullptr && set->value() != "0") names.push_back(quoted(name));
    }
    if (servo.kind == "intvelocity") names.emplace_back("the integrator of its speed");
    if (names.empty()) return;
    const std::string all = enumerated(names);
    lost(one, "a motor of SMURF has none of these, so they are lost: " + all);
  }

  /// Joints without a motor, which would have their armature. Of a ball, which a URDF has three
  /// joints for, it is lost.
  void undriven() {
    const Joint* first = nullptr;
    std::size_t count = 0;
    bool is_first = true;
    for (const Body& body : model_.bodies) {
      for (const Joint& joint : body.joints) {
        if (joint.type == Joint::Type::free || joint.armature == 0 || driven_.contains(joint.name))
          continue;
        if (joint.type == Joint::Type::ball) {
          if (count++ == 0) first = &joint;
          continue;
        }
        const Place place = joint.settings.place({"armature"});
        if (std::exchange(is_first, false)) yaml_.plain("joint:\n");
        line("- ", "name", yaml_text(joint.name), place);
        line("  ", "armature", format_number(joint.armature), place);
      }
    }
    if (first == nullptr) return;
    reporter_
        .report(
            rules::sml9304_lost_in_urdf, first->settings.place({"armature"}).origin,
            "a URDF has three joints for a ball, so the armature of " +
                (count == 1 ? "joint " + quoted(first->name) : std::to_string(count) + " balls") +
                " is lost")
        .help("keep the MJCF for it");
  }

  /// Sensors of joints and links; those with a place on a link are in `<gazebo>`.
  void sensor(const Reference& one) {
    constexpr std::pair<std::string_view, std::string_view> kTypes[] = {
        {"jointpos", "JointPosition"},       {"jointvel", "JointVelocity"},
        {"jointactuatorfrc", "JointTorque"}, {"actuatorfrc", "JointTorque"},
        {"framepos", "NodePosition"},        {"framequat", "NodeRotation"},
        {"framelinvel", "NodeVelocity"},     {"frameangvel", "NodeAngularVelocity"}};
    const std::string_view kind = one.element.name();
    const auto* row = std::find_if(std::begin(kTypes), std::end(kTypes),
                                   [&](const auto& known) { return known.first == kind; });
    if (row == std::end(kTypes)) {
      const Site* site = parts_.site(one.element.attribute("site"), one.around);
      const bool is_placed =
          is_one_of(kind, {"accelerometer", "gyro", "force", "torque", "touch", "rangefinder"});
      if (!is_placed || site == nullptr || site->body == 0) {
        lost(one, "SMURF has no sensor like " + quoted(kind) + ", so this one is lost");
      } else if (kind == "touch") {
        reporter_
            .lose(
                one.element.name_span(),
                "a contact sensor of SMURF measures all of a link, so the size of the site is lost",
                "lost sizes of sites")
            .help("keep the MJCF for it");
      }
      return;
    }
    if (row - std::begin(kTypes) >= 4) return frame_sensor(one, row->second);
    const auto [target, link] = joint_of(one);
    if (target.empty()) {
      lost(one, "SMURF has no " + quoted(kind) +
                    " of a joint with several axes or of a tendon, so this one is lost");
      return;
    }
    sensor_head(one, row->second, target, link);
  }

  void sensor_head(const Reference& one, std::string_view type, const std::string& target,
                   const std::string& link) {
    const Attribute* name = one.element.attribute("name");
    const Place tag{one.element.name_span(), one.element.tag_span(), one.around.frame};
    line("- ", "name",
         yaml_text(name != nullptr ? full_name(name->value(), one.around)
                                   : target + "_" + std::string(one.element.name())),
         tag);
    line("  ", "type", type, tag);
    line("  ", "link", yaml_text(link), tag);
    line("  ", "id", "[" + yaml_text(target) + "]", tag);
  }

  /// A sensor of a frame, in the world or in another frame.
  void frame_sensor(const Reference& one, std::string_view type) {
    if (is_part_of_imu(one)) return;
    const std::string_view kind = one.element.name();
    const bool is_place = is_one_of(kind, {"framepos", "framelinvel"});
    const bool is_relative = one.element.attribute("reftype") != nullptr;
    const auto frame = measured_frame(model_, parts_, one, "obj", reporter_);
    const auto reference = measured_frame(model_, parts_, one, "ref", reporter_);
    const bool is_known = is_on_link(frame) && (frame->has_known_axes || kind != "framequat") &&
                          (!is_relative || (is_on_link(reference) && reference->has_known_axes));
    if (!is_known)
      return lost(one, "no link has the frame of this " + quoted(kind) + ", so it is lost");
    const std::string& link = model_.bodies[frame->body].name;
    sensor_head(one, type, link, link);
    const Place place{one.element.attribute("objname")->value_span(), one.element.tag_span()};
    // The velocity of turning is the same everywhere on a link.
    if (is_place) position("position_offset", frame->X_BF.position, place);
    if (kind == "framequat") orientation("orientation_offset", frame->X_BF.orientation, place);
    if (!is_relative) return;
    const Place other{one.element.attribute("refname")->value_span(), one.element.tag_span()};
    line("  ", "reference", yaml_text(model_.bodies[reference->body].name), other);
    if (is_place) position("reference_position", reference->X_BF.position, other);
    orientation("reference_orientation", reference->X_BF.orientation, other);
  }

  bool is_on_link(const std::optional<MeasuredFrame>& frame) const {
    return frame && (frame->body != 0 || needs_world(model_));
  }

  void position(std::string_view key, const Vector3& p, const Place& place) {
    if (p == Vector3{}) return;
    line("  ", key,
         "{x: " + format_number(p[0]) + ", y: " + format_number(p[1]) +
             ", z: " + format_number(p[2]) + "}",
         place);
  }

  void orientation(std::string_view key, const Quaternion& q, const Place& place) {
    if (to_rpy(q) == Vector3{}) return;
    line("  ", key,
         "{w: " + format_number(q.w) + ", x: " + format_number(q.x) + ", y: " + format_number(q.y) +
             ", z: " + format_number(q.z) + "}",
         place);
  }

  /// The joint that a sensor measures, and the link that it moves.
  std::pair<std::string, std::string> joint_of(const Reference& one) const {
    const Attribute* name = one.element.attribute("joint");
    const Surroundings* around = &one.around;
    if (const Attribute* measured = one.element.attribute("actuator")) {
      if (const Reference* actuator = parts_.actuator(measured, one.around)) {
        name = actuator->element.attribute("joint");
        around = &actuator->around;
      }
    }
    const Joint* joint = parts_.joint(name, *around);
    const bool has_one_value = joint != nullptr && (joint->type == Joint::Type::hinge ||
                                                    joint->type == Joint::Type::slide);
    if (!has_one_value) return {};
    return {joint->name, parts_.body_of(*joint).name};
  }

  /// The first orientation of a site whose accelerations are measured, too.
  bool is_part_of_imu(const Reference& one) {
    const Attribute* kind = one.element.attribute("objtype");
    if (one.element.name() != "framequat" || kind == nullptr || kind->value() != "site" ||
        one.element.attribute("reftype") != nullptr)
      return false;
    return imus_.erase(parts_.site(one.element.attribute("objname"), one.around)) > 0;
  }

  /// Which shapes touch which, if not all of them touch each other, and how they slide.
  void collisions() {
    const Geom* one_sided = nullptr;
    for (const Body& body : model_.bodies) {
      for (const Geom& geom : body.geoms) {
        if (one_sided == nullptr && touches(geom) && !has_one_mask(geom)) one_sided = &geom;
      }
    }
    if (one_sided != nullptr) {
      const Place place = one_sided->settings.place({"contype", "conaffinity"});
      reporter_
          .report(rules::sml9304_lost_in_urdf, place.origin,
                  "SMURF has one mask of contacts for a shape, so those with two masks are lost")
          .help("write the same `contype` and `conaffinity`, with at most 16 bits");
    }
    const bool has_bits = has_masks(model_);
    bool is_open = false;
    for (const Body& body : model_.bodies) {
      for (const Geom& geom : body.geoms) {
        if (!touches(geom) || !geom.is_in_urdf) continue;
        if (!is_open) yaml_.plain("collision:\n");
        is_open = true;
        const Place bits = geom.settings.place({"contype", "conaffinity"});
        const Place friction = geom.settings.place({"friction"});
        line("- ", "name", yaml_text(geom.name), has_bits ? bits : friction);
        line("  ", "link", yaml_text(body.name), has_bits ? bits : friction);
        if (has_bits) line("  ", "bitmask", std::to_string(geom.contype), bits);
        line("  ", "cfriction1", format_number(friction_of(geom, reporter_)[0]), friction);
      }
    }
  }

  void tensors() {
    bool is_open = false;
    for (const Body& body : model_.bodies) {
      if (!body.mass || !(body.mass->mass > 0) || body.mass->inertia != imports::kUnitTensor)
        continue;
      if (!std::exchange(is_open, true)) yaml_.plain("link:\n");
      imports::keep_inertia(yaml_, body.name,
                            {body.element.name_span(), body.element.tag_span(), body.frame});
    }
  }

  void keyframe(const Reference& one) {
    if (one.around.file != &model_.files.front() || !one.around.prefix.empty()) return;
    const Attribute* values = one.element.attribute("qpos");
    std::size_t count = 0;
    for (const Body& body : model_.bodies) {
      for (const Joint& joint : body.joints) count += size_of(joint);
    }
    // Joints may be in a file that is not there.
    std::vector<double> numbers;
    if (values != nullptr)
      numbers = numbers_of(*values, 0, reporter_.lacks_file() ? kMost : count, reporter_);
    const Attribute* name = one.element.attribute("name");
    const Place tag{one.element.name_span(), one.element.tag_span()};
    const Place place =
        values != nullptr ? Place{values->value_span(), one.element.tag_span()} : tag;
    const std::string text =
        name != nullptr ? std::string(name->value()) : "key_" + std::to_string(keys_);
    ++keys_;
    line("- ", "name", yaml_text(text), tag);
    yaml_.plain("  joints:");
    std::map<std::string_view, double> positions;
    std::size_t at = 0;
    for (const Body& body : model_.bodies) {
      for (const Joint& joint : body.joints) {
        const std::size_t size = size_of(joint);
        if (size == 1) {
          // What is not written is as in the reference.
          const double position = at < numbers.size() ? numbers[at] : joint.reference;
          if (positions.empty()) yaml_.plain("\n");
          positions.emplace(joint.name, position);
          line("    ", yaml_text(joint.name), format_number(position), place);
        } else if (at < numbers.size()) {
          lost(one, "a pose of SMURF has no values of free and ball joints, so they are lost");
        }
        at += size;
      }
    }
    if (positions.empty()) yaml_.plain(" {}\n");
    motion_of_keyframe(one, positions);
  }

  /// Speeds, and commands other than those that hold the pose.
  void motion_of_keyframe(const Reference& one,
                          const std::map<std::string_view, double>& positions) {
    const auto numbers = [&](std::string_view name) {
      const Attribute* written = one.element.attribute(name);
      return written == nullptr ? std::vector<double>() : numbers_of(*written, 0, kMost, reporter_);
    };
    const auto is_zero = [](double number) { return number == 0; };
    std::vector<std::string> names;
    for (const std::string_view name : {"qvel", "act"}) {
      const std::vector<double> all = numbers(name);
      if (!std::all_of(all.begin(), all.end(), is_zero)) names.push_back(quoted(name));
    }
    std::vector<double> holding;
    for (const Reference& other : model_.sections) {
      if (other.section == "actuator") holding.push_back(holding_command(other, positions));
    }
    std::vector<double> commands = numbers("ctrl");
    holding.resize(commands.size());
    const auto is_near = [](double a, double b) { return std::fabs(a - b) <= 1e-6; };
    if (!std::equal(commands.begin(), commands.end(), holding.begin(), is_near))
      names.push_back(quoted("ctrl"));
    if (!names.empty())
      lost(one, "a pose of SMURF has only positions of joints, so " + enumerated(names) +
                    (names.size() == 1 ? " is lost" : " are lost"));
  }

  /// The command with which an actuator holds its joint; 0 for one that does not.
  double holding_command(const Reference& one,
                         const std::map<std::string_view, double>& positions) {
    const Settings s = settings_of_actuator(one);
    const auto servo = servo_of(s, reporter_);
    const Joint* joint = parts_.joint(one.element.attribute("joint"), one.around);
    if (!servo || servo->kind != "position" || joint == nullptr) return 0;
    const auto known = positions.find(joint->name);
    return known == positions.end() ? 0 : known->second * gear_of(s, reporter_);
  }

  static std::size_t size_of(const Joint& joint) {
    return joint.type == Joint::Type::free ? 7 : joint.type == Joint::Type::ball ? 4 : 1;
  }

  const Model& model_;
  Reporter& reporter_;
  imports::TracedYaml yaml_;
  PartsByName parts_;
  std::set<const Site*> imus_;  ///< whose accelerations are measured, and not yet their orientation
  std::set<std::string> driven_;
  std::optional<MovedInertia> inertias_;  ///< where a damping depends on it
  std::size_t keys_ = 0;
};

}  // namespace

std::string write_annotations(const Model& model, Reporter& reporter, xacro::Expansion& expansion) {
  return AnnotationWriter(model, reporter, expansion).run();
}

}  // namespace smurf::mjcf
