// SPDX-License-Identifier: BSD-3-Clause
// The tree of bodies as links and joints of a URDF. Frames of bodies are kept; a joint beside the
// frame of its body, and several joints of a body, make links without mass.
#include "mjcf/robot.hpp"

#include <algorithm>
#include <cmath>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/unique_names.hpp"
#include "imports/joint_xml.hpp"
#include "mjcf/extensions.hpp"
#include "mjcf/shapes.hpp"

namespace smurf::mjcf {
namespace {

using imports::JointText;

constexpr double kUnlimited = 1e16;

class RobotWriter {
 public:
  RobotWriter(const Model& model, const JointFacts& facts, Reporter& reporter,
              xacro::Expansion& expansion)
      : model_(model), facts_(facts), reporter_(reporter), expansion_(expansion), xml_(expansion) {
    for (const Body& body : model.bodies) {
      links_.take(body.name);
      for (const Joint& joint : body.joints) joints_.take(joint.name);
    }
  }

  std::string run() {
    const View root = model_.files.front().root();
    const Place place = place_of(root);
    xml_.open("robot", place);
    const Attribute* name = root.attribute("model");
    Place of_name = name != nullptr ? Place{name->value_span(), root.tag_span()} : place;
    of_name.is_exact = name != nullptr;
    xml_.attribute("name", model_.name, of_name);
    ShapeWriter shapes(model_, reporter_, expansion_, xml_);
    shapes.write_materials();
    const bool has_world = needs_world(model_);
    for (std::size_t i = has_world ? 0 : 1; i < model_.bodies.size(); ++i) {
      const Body& body = model_.bodies[i];
      if (i > 0) joints_to(body, has_world);
      link(body, shapes, i == 0);
    }
    ExtensionWriter(model_, facts_, holders_, has_world, reporter_, xml_).write_all();
    xml_.close();
    return xml_.take();
  }

 private:
  static Place place_of(View element, xacro::FrameId frame = xacro::kNoFrame) {
    return {element.name_span(), element.tag_span(), frame};
  }

  Place name_place(const Body& body) const {
    const Attribute* name = body.element.attribute("name");
    Place place = name != nullptr && body.has_name
                      ? Place{name->value_span(), body.element.tag_span(), body.frame}
                      : place_of(body.element, body.frame);
    place.is_exact = name != nullptr && name->value() == body.name;
    return place;
  }

  Place settings_place(const Joint& joint, std::initializer_list<std::string_view> names) {
    Place place = joint.settings.place(names);
    place.frame = frame_of(place, joint.settings, joint.frame, model_, expansion_);
    return place;
  }

  void link(const Body& body, ShapeWriter& shapes, bool is_world) {
    const Place place =
        is_world ? place_of(model_.files.front().root()) : place_of(body.element, body.frame);
    xml_.open("link", place, is_world);
    xml_.attribute("name", body.name, is_world ? place : name_place(body));
    if (!is_world) inertial(body);
    for (const Geom& geom : body.geoms) shapes.write(geom);
    xml_.close();
  }

  void inertial(const Body& body) {
    if (!body.mass || !(body.mass->mass > 0)) return;
    const MassProperties& mass = *body.mass;
    Place tag = place_of(body.element, body.frame);
    Place of_mass = tag;
    Place of_center = tag;
    Place of_inertia = tag;
    const bool is_written =
        body.inertial && body.file->compiler().inertiafromgeom != InertiaFromGeom::yes;
    if (is_written) {
      const Settings s(body.inertial, nullptr);
      tag = place_of(body.inertial, body.frame);
      of_mass = with_frame(s.place({"mass"}), body.frame);
      of_center = with_frame(s.place({"pos"}), body.frame);
      of_inertia = with_frame(s.place({"diaginertia", "fullinertia"}), body.frame);
    } else if (const Geom* largest = heaviest(body)) {
      Place of_shape = largest->settings.place({"mass", "density", "size", "mesh"});
      of_shape.frame = frame_of(of_shape, largest->settings, body.frame, model_, expansion_);
      of_mass = of_center = of_inertia = of_shape;
    }
    xml_.open("inertial", tag);
    xml_.open("origin", tag);
    xml_.attribute("xyz", words_of(mass.center), of_center);
    xml_.close();
    xml_.open("mass", tag);
    xml_.number("value", mass.mass, of_mass);
    xml_.close();
    xml_.open("inertia", tag);
    constexpr std::pair<std::string_view, std::size_t> kMoments[] = {
        {"ixx", 0}, {"ixy", 3}, {"ixz", 4}, {"iyy", 1}, {"iyz", 5}, {"izz", 2}};
    for (const auto& [name, i] : kMoments) xml_.number(name, mass.inertia[i], of_inertia);
    xml_.close();
    xml_.close();
  }

  static const Geom* heaviest(const Body& body) {
    const Geom* best = nullptr;
    for (const Geom& geom : body.geoms) {
      if (geom.mass && geom.mass->mass > 0 &&
          (best == nullptr || geom.mass->mass > best->mass->mass))
        best = &geom;
    }
    return best;
  }

  static Place with_frame(Place place, xacro::FrameId frame) {
    place.frame = frame;
    return place;
  }

  /// A joint that nobody wrote.
  JointText made_joint(std::string_view name, std::string_view type, std::string_view parent,
                       std::string_view child, const Pose& X, const Place& tag,
                       const Place& of_pose) {
    JointText joint{
        .name = name, .type = type, .parent = parent, .child = child, .X_PJ = X, .tag = tag};
    joint.blame_tag();
    joint.of_pose = of_pose;
    joint.is_made = true;
    holders_[std::string(child)] = name;
    return joint;
  }

  void joints_to(const Body& body, bool has_world) {
    const std::string& parent = model_.bodies[body.parent].name;
    const Settings own(body.element, nullptr);
    const Place of_pose =
        with_frame(own.place({"pos", "quat", "euler", "axisangle", "xyaxes", "zaxis"}), body.frame);
    const Place tag = place_of(body.element, body.frame);
    if (body.joints.empty()) {
      const std::string name = joints_.add(body.name + "_fixed");
      add_fixed_joint(xml_, made_joint(name, "fixed", parent, body.name, body.pose, tag, of_pose));
      return;
    }
    if (body.joints.front().type == Joint::Type::free) {
      if (!has_world) return;
      const Joint& joint = body.joints.front();
      JointText text = made_joint(joint.name, "floating", parent, body.name, Pose{},
                                  place_of(joint.settings.element(), joint.frame), of_pose);
      text.is_made = false;
      open_joint(xml_, text);
      xml_.close();
      return;
    }
    chain(body, parent, of_pose);
  }

  void chain(const Body& body, const std::string& parent, const Place& of_pose) {
    std::string from = parent;
    Vector3 anchor{};  // of the joint before
    Pose X = body.pose;
    for (std::size_t k = 0; k < body.joints.size(); ++k) {
      const Joint& joint = body.joints[k];
      const bool is_slide = joint.type == Joint::Type::slide;
      const Vector3 at = is_slide ? Vector3{} : joint.position;
      X = X * Pose{{at[0] - anchor[0], at[1] - anchor[1], at[2] - anchor[2]}, {}};
      anchor = at;
      const bool is_last = k + 1 == body.joints.size() && anchor == Vector3{};
      const std::string to = is_last ? body.name : links_.add(body.name + "__" + joint.name);
      const Place place = place_of(joint.settings.element(), joint.frame);
      if (joint.type == Joint::Type::ball) {
        ball(joint, from, to, X, of_pose);
      } else {
        if (joint.reference != 0) {
          const double v = -joint.reference;
          X = X * (is_slide ? Pose{{joint.axis[0] * v, joint.axis[1] * v, joint.axis[2] * v}, {}}
                            : Pose{{}, from_axis_angle(joint.axis, v)});
        }
        single(joint, from, to, X, of_pose);
      }
      if (!is_last) add_made_link(xml_, to, place);
      from = to;
      X = Pose{};
    }
    if (anchor == Vector3{}) return;
    const Place last = place_of(body.joints.back().settings.element(), body.joints.back().frame);
    const std::string name = joints_.add(body.name + "_at");
    const Pose X_back{{-anchor[0], -anchor[1], -anchor[2]}, {}};
    add_fixed_joint(xml_, made_joint(name, "fixed", from, body.name, X_back, last, last));
  }

  void ball(const Joint& joint, const std::string& from, const std::string& to, const Pose& X,
            const Place& of_pose) {
    const Place tag = place_of(joint.settings.element(), joint.frame);
    std::string parent = from;
    constexpr std::pair<std::string_view, std::string_view> kAxes[] = {
        {"_x", "1 0 0"}, {"_y", "0 1 0"}, {"_z", "0 0 1"}};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string child =
          i == 2 ? to : links_.add(to + "__" + joint.name + std::string(kAxes[i].first));
      const std::string name = joints_.add(joint.name + std::string(kAxes[i].first));
      open_joint(xml_,
                 made_joint(name, "continuous", parent, child, i == 0 ? X : Pose{}, tag, of_pose));
      xml_.open("axis", tag);
      xml_.attribute("xyz", kAxes[i].second, tag);
      xml_.close();
      dynamics(joint);
      xml_.close();
      if (i < 2) add_made_link(xml_, child, tag);
      parent = child;
    }
    if (joint.is_limited) {
      reporter_
          .report(
              rules::sml9304_lost_in_urdf, joint.settings.place({"range"}).origin,
              "three joints of a URDF stand for a ball joint, and none of them limits its angle")
          .help("keep the MJCF for the limit");
    }
  }

  void single(const Joint& joint, const std::string& from, const std::string& to, const Pose& X,
              const Place& of_pose) {
    const bool is_slide = joint.type == Joint::Type::slide;
    const std::string_view type = is_slide           ? "prismatic"
                                  : joint.is_limited ? "revolute"
                                                     : "continuous";
    const Settings& s = joint.settings;
    const Place tag = place_of(s.element(), joint.frame);
    JointText text = made_joint(joint.name, type, from, to, X, tag, of_pose);
    text.is_made = false;
    const Attribute* name = s.element().attribute("name");
    if (name != nullptr && joint.has_name) {
      text.of_name.origin = name->value_span();
      text.of_name.is_exact = name->value() == joint.name;
    }
    text.of_type = settings_place(joint, {"type", "range"});
    open_joint(xml_, text);
    xml_.open("axis", tag);
    xml_.attribute("xyz", words_of(joint.axis), settings_place(joint, {"axis"}));
    xml_.close();
    limit(joint, is_slide);
    dynamics(joint);
    const auto follower = facts_.followers.find(joint.name);
    if (follower != facts_.followers.end()) {
      const Settings of_mimic(follower->second.element, nullptr);
      const Place place = of_mimic.place({"polycoef"});
      xml_.open("mimic",
                {follower->second.element.name_span(), follower->second.element.tag_span()});
      xml_.attribute("joint", follower->second.leader, of_mimic.place({"joint2"}));
      xml_.number("multiplier", follower->second.multiplier, place);
      xml_.number("offset", follower->second.offset, place);
      xml_.close();
    }
    xml_.close();
  }

  void limit(const Joint& joint, bool is_slide) {
    const auto actuated = facts_.efforts.find(joint.name);
    const bool has_effort = joint.force_range || actuated != facts_.efforts.end();
    if (!joint.is_limited && !is_slide && !has_effort) return;
    const Place tag = place_of(joint.settings.element(), joint.frame);
    xml_.open("limit", tag);
    if (joint.force_range) {
      const auto& [low, high] = *joint.force_range;
      xml_.number("effort", std::max(std::fabs(low), std::fabs(high)),
                  settings_place(joint, {"actuatorfrcrange"}));
      if (low != -high) {
        reporter_
            .report(rules::sml9304_lost_in_urdf, settings_place(joint, {"actuatorfrcrange"}).origin,
                    "a URDF has one effort for both directions, so the smaller one is lost")
            .help("write both numbers of the same size if the difference does not matter");
      }
    } else if (actuated != facts_.efforts.end()) {
      xml_.number("effort", actuated->second.first, actuated->second.second);
    } else {
      xml_.number("effort", kUnlimited, tag, true);
    }
    const Place range = settings_place(joint, {"range"});
    if (joint.is_limited || is_slide) {
      const bool is_made = !joint.is_limited;
      xml_.number("lower", is_made ? -kUnlimited : joint.range[0], range, is_made);
      xml_.number("upper", is_made ? kUnlimited : joint.range[1], range, is_made);
    }
    xml_.number("velocity", kUnlimited, tag, true);
    xml_.close();
  }

  void dynamics(const Joint& joint) {
    if (joint.damping == 0 && joint.friction == 0) return;
    xml_.open("dynamics", place_of(joint.settings.element(), joint.frame));
    if (joint.damping != 0)
      xml_.number("damping", joint.damping, settings_place(joint, {"damping", "springdamper"}));
    if (joint.friction != 0)
      xml_.number("friction", joint.friction, settings_place(joint, {"frictionloss"}));
    xml_.close();
  }

  const Model& model_;
  const JointFacts& facts_;
  Reporter& reporter_;
  xacro::Expansion& expansion_;
  TracedXml xml_;
  UniqueNames links_, joints_;
  std::map<std::string, std::string> holders_;  ///< by link, the joint that holds it
};

}  // namespace

std::string write_robot(const Model& model, const JointFacts& facts, Reporter& reporter,
                        xacro::Expansion& expansion) {
  return RobotWriter(model, facts, reporter, expansion).run();
}

}  // namespace smurf::mjcf
