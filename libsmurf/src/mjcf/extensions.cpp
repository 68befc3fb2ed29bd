// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/extensions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/findings/rules.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"

namespace smurf::mjcf {
namespace {

using imports::Place;

/// Cameras of Gazebo look along x, with z up; those of MuJoCo along -z, with y up.
const Quaternion kCameraOfGazebo{0.5, -0.5, 0.5, 0.5};
/// Single rays of Gazebo go along x, those of MuJoCo along z.
const Quaternion kRayOfGazebo{std::numbers::sqrt2 / 2, 0, -std::numbers::sqrt2 / 2, 0};
constexpr double kRadians = std::numbers::pi / 180;

}  // namespace

void ExtensionWriter::write_all() {
  for (const ClosedLoop& one : facts_.loops) loop(one);
  springs();
  for (const Reference& one : model_.sections) {
    if (one.section == "sensor") sensor(one);
  }
  for (const Camera& one : model_.cameras) camera(one);
}

void ExtensionWriter::loop(const ClosedLoop& loop) {
  const Place tag{loop.element.name_span(), loop.element.tag_span(), loop.frame};
  const bool needs_world =
      loop.parent == model_.bodies.front().name || loop.child == model_.bodies.front().name;
  if (needs_world && !has_world_) {
    reporter_
        .report(rules::sml9304_lost_in_urdf, tag.origin,
                "the robot floats, so a URDF of it has no world, and " +
                    quoted(loop.element.name()) + " of " + quoted(loop.child) +
                    " and the world is lost")
        .help("keep the MJCF for it");
    return;
  }
  imports::JointText joint{.name = loop.name,
                           .type = loop.is_ball ? "ball" : "fixed",
                           .parent = loop.parent,
                           .child = loop.child,
                           .tag = tag};
  joint.blame_tag();
  joint.of_pose = tag;
  open_loop(xml_, joint, loop.X_CJ);
  xml_.close();
  xml_.close();
}

void ExtensionWriter::springs() {
  for (const Body& body : model_.bodies) {
    for (const Joint& joint : body.joints) {
      if (joint.stiffness == 0) continue;
      Place stiffness = joint.settings.place({"stiffness", "springdamper"});
      if (joint.type != Joint::Type::hinge && joint.type != Joint::Type::slide) {
        reporter_
            .lose(stiffness.origin,
                  "a URDF has no spring of a joint with several axes, so it is lost",
                  "lost springs")
            .help("keep the MJCF for it");
        continue;
      }
      Place reference = joint.settings.place({"springref"});
      const View element = joint.settings.element();
      const Place tag{element.name_span(), element.tag_span(), joint.frame};
      stiffness.frame = reference.frame = joint.frame;
      xml_.open("gazebo", tag);
      xml_.attribute("reference", joint.name, tag);
      add_leaf(xml_, "springStiffness", format_number(joint.stiffness), stiffness);
      add_leaf(xml_, "springReference", format_number(joint.springref), reference);
      xml_.close();
    }
  }
}

const Site* ExtensionWriter::site_of(const Reference& one) const {
  const Attribute* name = one.element.attribute("site");
  const Attribute* kind = one.element.attribute("objtype");
  if (name == nullptr && kind != nullptr && kind->value() == "site")
    name = one.element.attribute("objname");
  return parts_.site(name, one.around);
}

void ExtensionWriter::open_sensor(std::string_view reference, const std::string& name,
                                  std::string_view type, const Pose& X_LS, const Place& tag) {
  xml_.open("gazebo", tag);
  xml_.attribute("reference", reference, tag);
  xml_.open("sensor", tag);
  xml_.attribute("name", name, tag, true);
  xml_.attribute("type", type, tag);
  const Vector3 rpy = to_rpy(X_LS.orientation);
  if (X_LS.position != Vector3{} || rpy != Vector3{})
    add_leaf(xml_, "pose", words_of(X_LS.position) + " " + words_of(rpy), tag);
}

void ExtensionWriter::close_sensor() {
  xml_.close();
  xml_.close();
}

void ExtensionWriter::sensor(const Reference& one) {
  const Site* site = site_of(one);
  if (site == nullptr || (site->body == 0 && !has_world_)) return;
  const std::string_view kind = one.element.name();
  const Body& body = model_.bodies[site->body];
  const Place tag{one.element.name_span(), one.element.tag_span(), one.around.frame};
  const Attribute* own = one.element.attribute("name");
  const std::string name =
      own != nullptr ? full_name(own->value(), one.around) : site->name + "_" + std::string(kind);
  if (is_one_of(kind, {"accelerometer", "gyro"})) {
    // Both, and the orientation of the site, are one sensor of Gazebo.
    if (known_.insert({"imu", site}).second) {
      open_sensor(body.name, site->name, "imu", site->pose, tag);
      close_sensor();
    }
  } else if (is_one_of(kind, {"force", "torque"})) {
    const auto holder = holders_.find(body.name);
    if (holder == holders_.end() || !known_.insert({"wrench", site}).second) return;
    open_sensor(holder->second, site->name, "force_torque", site->pose, tag);
    xml_.open("force_torque", tag);
    add_leaf(xml_, "frame", "sensor", tag);
    add_leaf(xml_, "measure_direction", "child_to_parent", tag);
    xml_.close();
    close_sensor();
  } else if (kind == "touch") {
    open_sensor(body.name, name, "contact", {}, tag);
    close_sensor();
  } else if (kind == "rangefinder") {
    open_sensor(body.name, name, "ray", site->pose * Pose{{}, kRayOfGazebo}, tag);
    xml_.open("ray", tag);
    xml_.open("scan", tag);
    xml_.open("horizontal", tag);
    for (const auto& [part, value] : {std::pair{"samples", "1"}, std::pair{"resolution", "1"},
                                      std::pair{"min_angle", "0"}, std::pair{"max_angle", "0"}})
      add_leaf(xml_, part, value, tag);
    xml_.close();
    xml_.close();
    const Settings s(one.element, nullptr);
    const double farthest = s.number("cutoff", 0, reporter_);
    if (farthest > 0) {
      xml_.open("range", tag);
      add_leaf(xml_, "min", "0", tag);
      add_leaf(xml_, "max", format_number(farthest), s.place({"cutoff"}));
      xml_.close();
    }
    xml_.close();
    close_sensor();
  }
}

/// A camera of the world shows the scene, and one that follows something is no part of a robot.
void ExtensionWriter::camera(const Camera& camera) {
  const Settings& s = camera.settings;
  const std::string_view mode = s.text("mode");
  if (camera.body == 0 || (!mode.empty() && mode != "fixed") || camera.name.empty()) return;
  const View element = s.element();
  const Place tag{element.name_span(), element.tag_span()};
  std::array<double, 2> resolution{1, 1};
  s.numbers("resolution", resolution, 2, reporter_);
  if (!(resolution[0] > 1) || !(resolution[1] > 1)) resolution = {640, 480};
  const double fovy = s.number("fovy", 45, reporter_);
  if (!(fovy > 0) || !(fovy < 180)) return;
  const auto [sine, cosine] = sine_cosine(fovy * kRadians / 2);
  const double fovx = 2 * arc_tangent(sine * resolution[0], cosine * resolution[1]);
  open_sensor(model_.bodies[camera.body].name, camera.name, "camera",
              camera.pose * Pose{{}, kCameraOfGazebo}, tag);
  xml_.open("camera", tag);
  add_leaf(xml_, "horizontal_fov", format_number(fovx), s.place({"fovy"}));
  xml_.open("image", tag);
  add_leaf(xml_, "width", format_number(resolution[0]), s.place({"resolution"}));
  add_leaf(xml_, "height", format_number(resolution[1]), s.place({"resolution"}));
  xml_.close();
  xml_.close();
  close_sensor();
}

}  // namespace smurf::mjcf
