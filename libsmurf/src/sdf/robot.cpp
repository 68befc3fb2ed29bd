// SPDX-License-Identifier: BSD-3-Clause
// Links and joints as those of a URDF. Frames of links are kept; a joint beside the frame of its
// child, and a joint with several axes, make links without mass.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/unique_names.hpp"
#include "imports/joint_xml.hpp"
#include "sdf/extensions.hpp"
#include "sdf/shapes.hpp"

namespace smurf::sdformat {
namespace {

constexpr std::string_view kWorld = "world";

/// Without what remains of numbers that cancel each other out.
Pose cleaned(Pose X) {
  constexpr double kRounding = 1e-15;
  for (double& one : X.position) one = std::fabs(one) < kRounding ? 0 : one;
  for (double* one : {&X.orientation.x, &X.orientation.y, &X.orientation.z})
    *one = std::fabs(*one) < kRounding ? 0 : *one;
  return X;
}

bool is_identity(const Pose& X) {
  return X.position == Vector3{} && to_rpy(X.orientation) == Vector3{};
}

class RobotWriter {
 public:
  RobotWriter(Model& model, Files& files, Reporter& reporter, xacro::Expansion& expansion)
      : model_(model),
        reporter_(reporter),
        xml_(expansion, reporter.context().limits.xacro_bytes / 2),
        shapes_(model, files, reporter, xml_),
        extensions_(model, reporter, xml_),
        frames_(reporter) {}

  std::string run() {
    holders_.assign(model_.links.size(), nullptr);
    for (const Link& link : model_.links) links_.take(link.name);
    for (const Joint& joint : model_.joints) {
      joints_.take(joint.name);
      joint_of_.emplace(joint.vertex, &joint);
      if (joint.is_in_tree) holders_[*joint.child.link] = &joint;
    }
    const Place place = tag_of(model_.element, xacro::kNoFrame);
    const Attribute* name = model_.element.attribute("name");
    xml_.open("robot", place);
    xml_.attribute("name", model_.name,
                   name != nullptr ? Place{name->value_span(), place.use, xacro::kNoFrame, true}
                                   : place);
    const bool has_world = !root_of(model_);
    if (has_world) {
      xml_.open("link", place, true);
      xml_.attribute("name", kWorld, place, true);
      xml_.close();
    } else if (!is_identity(model_.X_W)) {
      const View pose = model_.element.child("pose");
      reporter_
          .report(rules::sml9304_lost_in_urdf, pose ? pose.name_span() : place.origin,
                  "a URDF has no place in a world, so the pose of the model is lost")
          .help("give the pose to the program that puts the robot into a world");
    }
    for (std::size_t i = 0; i < model_.links.size() && !xml_.is_full(); ++i) {
      const Link& link = model_.links[i];
      if (holders_[i] != nullptr) {
        joint_to(link, *holders_[i]);
      } else if (has_world) {
        free_joint(link);
      }
      write(link);
    }
    extensions_.write_all();
    xml_.close();
    if (xml_.is_full()) {
      reporter_.exceed(place.origin,
                       "the robot has more than " +
                           std::to_string(reporter_.context().limits.xacro_bytes / 2) + " bytes",
                       "xacro-bytes");
    }
    return xml_.take();
  }

 private:
  std::string name_of(const Body& body) const {
    return body.link ? model_.links[*body.link].name : std::string(kWorld);
  }
  Pose pose_of(const Body& body) const { return body.link ? model_.links[*body.link].X_W : Pose{}; }

  static Place name_place(const Vertex& vertex, std::string_view name) {
    const Attribute* written = vertex.element.attribute("name");
    Place place = tag_of(vertex.element, vertex.scope->frame);
    if (written == nullptr) return place;
    place.origin = written->value_span();
    place.is_exact = written->value() == name;
    return place;
  }

  /// The place of a number, which is exact if it is written in the same way.
  static Place number_place(View element, std::string_view child, double value,
                            xacro::FrameId frame) {
    Place place = place_in(element, child, frame);
    place.is_exact = format_number(value) == text_in(element, child);
    return place;
  }

  void write(const Link& link) {
    const Place tag = tag_of(link.vertex->element, link.vertex->scope->frame);
    xml_.open("link", tag);
    // Rules on names are not meant for those that nesting makes.
    xml_.attribute("name", link.name, name_place(*link.vertex, link.name),
                   link.name != link.vertex->name);
    inertial(link);
    shapes_.write(link);
    xml_.close();
  }

  void inertial(const Link& link) {
    if (!link.mass || !(link.mass->mass > 0)) return;
    const View element = link.vertex->element.child("inertial");
    const xacro::FrameId frame = link.vertex->scope->frame;
    const Place tag = tag_of(element ? element : link.vertex->element, frame);
    const MassProperties& mass = *link.mass;
    const auto number = [&](View in, std::string_view name, std::string_view as, double value,
                            const Place& usual) {
      const bool is_written = in && in.child(name);
      xml_.number(as, value, is_written ? number_place(in, name, value, frame) : usual);
    };
    // What nobody wrote is reported as such (SML9315), and what cannot move needs no mass.
    xml_.open("inertial", tag, !element || link.is_static);
    add_origin(xml_, link.X_inertial * Pose{mass.center, {}}, tag, link.of_center);
    xml_.open("mass", tag);
    number(element, "mass", "value", mass.mass, link.of_mass);
    xml_.close();
    const View inertia = element ? element.child("inertia") : View();
    xml_.open("inertia", tag, !inertia);
    constexpr std::pair<std::string_view, std::size_t> kMoments[] = {
        {"ixx", 0}, {"ixy", 3}, {"ixz", 4}, {"iyy", 1}, {"iyz", 5}, {"izz", 2}};
    for (const auto& [name, i] : kMoments)
      number(inertia, name, name, mass.inertia[i], link.of_inertia);
    xml_.close();
    xml_.close();
  }

  void open_joint(std::string_view name, const Place& of_name, std::string_view type,
                  const std::string& from, const std::string& to, const Pose& X, const Place& tag,
                  const Place& of_pose, bool is_made) {
    imports::open_joint(xml_, {.name = name,
                               .type = type,
                               .parent = from,
                               .child = to,
                               .X_PJ = cleaned(X),
                               .tag = tag,
                               .of_name = of_name,
                               .of_type = of_type_,
                               .of_parent = of_parent_,
                               .of_child = of_child_,
                               .of_pose = of_pose,
                               .is_made = is_made,
                               .is_name_made = name.find("::") != std::string_view::npos});
  }

  void forget_ends(const Place& tag) { of_type_ = of_parent_ = of_child_ = tag; }

  /// A link that nothing holds: fixed if it is static, else free.
  void free_joint(const Link& link) {
    const Place tag = tag_of(link.vertex->element, link.vertex->scope->frame);
    const Place of_pose = place_in(link.vertex->element, "pose", link.vertex->scope->frame);
    forget_ends(tag);
    const std::string_view type = link.is_static ? "fixed" : "floating";
    open_joint(joints_.add(link.name + (link.is_static ? "_fixed" : "_free")), tag, type,
               std::string(kWorld), link.name, link.X_W, tag, of_pose, true);
    xml_.close();
  }

  void joint_to(const Link& link, const Joint& joint) {
    const Vertex& vertex = *joint.vertex;
    const Place tag = tag_of(vertex.element, vertex.scope->frame);
    const View pose = vertex.element.child("pose");
    const Place of_pose = pose ? place_of(pose, vertex.scope->frame)
                               : place_in(link.vertex->element, "pose", vertex.scope->frame);
    const Pose X_WJ = joint.is_at_child ? link.X_W : joint.X_W;
    const Pose X_PJ = inverse(pose_of(joint.parent)) * X_WJ;
    const Pose X_JC = joint.is_at_child ? Pose{} : cleaned(inverse(X_WJ) * link.X_W);
    const bool is_beside = !is_identity(X_JC) && joint.type != Joint::Type::fixed;
    const std::string to =
        is_beside ? links_.add(link.name + "__" + std::string(vertex.name)) : link.name;
    ends_of(joint);
    const Pose X = joint.type == Joint::Type::fixed ? X_PJ * X_JC : X_PJ;
    switch (joint.type) {
    case Joint::Type::ball: ball(joint, to, X, of_pose); break;
    case Joint::Type::universal:
    case Joint::Type::revolute2: two_axes(joint, to, X, of_pose); break;
    case Joint::Type::screw: screw(joint, to, X, of_pose); break;
    default: single(joint, to, X, of_pose); break;
    }
    if (!is_beside) return;
    add_made_link(xml_, to, tag);
    const std::string name = joints_.add(link.name + "_at");
    add_fixed_joint(xml_, {.name = name,
                           .parent = to,
                           .child = link.name,
                           .X_PJ = cleaned(X_JC),
                           .tag = tag,
                           .of_pose = of_pose,
                           .is_name_made = true});
  }

  void ends_of(const Joint& joint) {
    const View element = joint.vertex->element;
    const xacro::FrameId frame = joint.vertex->scope->frame;
    const Attribute* type = element.attribute("type");
    of_type_ = tag_of(element, frame);
    if (type != nullptr) of_type_.origin = type->value_span();
    of_parent_ = place_in(element, "parent", frame);
    of_parent_.is_exact = name_of(joint.parent) == joint.parent_name;
    of_child_ = place_in(element, "child", frame);
    of_child_.is_exact = name_of(joint.child) == joint.child_name;
  }

  void axis_line(const Joint& joint, const Axis& axis) {
    const xacro::FrameId frame = joint.vertex->scope->frame;
    const View element = axis.element ? axis.element : joint.vertex->element;
    Vector3 v = axis.xyz;
    constexpr double kRounding = 1e-15;
    for (double& one : v) one = std::fabs(one) < kRounding ? 0 : one;
    Place place = place_in(element, "xyz", frame);
    place.is_exact = text_in(element, "xyz") == words_of(v);
    xml_.open("axis", tag_of(element, frame));
    // Rules on rounding are meant for what was written.
    xml_.attribute("xyz", words_of(v), place, !place.is_exact);
    xml_.close();
  }

  void limit(const Joint& joint, const Axis& axis, bool is_slide) {
    const bool has_limits = axis.has_limits() && joint.type != Joint::Type::continuous;
    const bool has_bounds = axis.effort < kUnlimited || axis.velocity < kUnlimited;
    if (!has_limits && !has_bounds && !is_slide) return;
    const xacro::FrameId frame = joint.vertex->scope->frame;
    const View element = axis.element ? axis.element.child("limit") : View();
    const View base = element ? element : joint.vertex->element;
    const Place tag = tag_of(base, frame);
    const auto number = [&](std::string_view name, double value) {
      const bool is_made = !(element && element.child(name)) || std::fabs(value) >= kUnlimited;
      const double finite = std::isfinite(value) ? value : std::copysign(kUnlimited, value);
      xml_.number(name, finite, number_place(base, name, value, frame), is_made);
    };
    xml_.open("limit", tag);
    number("effort", axis.effort);
    if (has_limits || is_slide) {
      number("lower", axis.lower);
      number("upper", axis.upper);
    }
    number("velocity", axis.velocity);
    xml_.close();
  }

  void dynamics(const Joint& joint, const Axis& axis) {
    if (axis.damping == 0 && axis.friction == 0) return;
    const View element = axis.element.child("dynamics");
    const xacro::FrameId frame = joint.vertex->scope->frame;
    xml_.open("dynamics", tag_of(element, frame));
    if (axis.damping != 0)
      xml_.number("damping", axis.damping, number_place(element, "damping", axis.damping, frame));
    if (axis.friction != 0)
      xml_.number("friction", axis.friction,
                  number_place(element, "friction", axis.friction, frame));
    xml_.close();
  }

  void mimic(const Joint& joint, const Axis& axis) {
    const View element = axis.element ? axis.element.child("mimic") : View();
    if (!element) return;
    const Attribute* leader = element.attribute("joint");
    if (leader == nullptr) return;
    const xacro::FrameId frame = joint.vertex->scope->frame;
    const Vertex* found = Frames::find(*joint.vertex->scope, leader->value());
    const auto followed = joint_of_.find(found);
    if (followed == joint_of_.end()) {
      reporter_.refuse(leader->value_span(), "there is no joint " + quoted(leader->value()),
                       "name a joint of the model");
      return;
    }
    const bool is_second = attribute_of(element, "axis") == "axis2";
    const double multiplier = number_in(element, "multiplier", 1);
    const double offset =
        number_in(element, "offset", 0) - multiplier * number_in(element, "reference", 0);
    Place of_leader = tag_of(element, frame);
    of_leader.origin = leader->value_span();
    xml_.open("mimic", tag_of(element, frame));
    xml_.attribute("joint", followed->second->name + (is_second ? "_2" : ""), of_leader);
    xml_.number("multiplier", multiplier, place_in(element, "multiplier", frame));
    xml_.number("offset", offset, place_in(element, "offset", frame));
    xml_.close();
  }

  static std::string_view type_of(const Joint& joint, const Axis& axis) {
    if (joint.type == Joint::Type::fixed) return "fixed";
    if (joint.type == Joint::Type::prismatic) return "prismatic";
    if (joint.type == Joint::Type::continuous) return "continuous";
    return axis.has_limits() ? "revolute" : "continuous";
  }

  void single(const Joint& joint, const std::string& to, const Pose& X, const Place& of_pose) {
    const Axis& axis = joint.axes[0];
    const Place tag = tag_of(joint.vertex->element, joint.vertex->scope->frame);
    open_joint(joint.name, name_place(*joint.vertex, joint.name), type_of(joint, axis),
               name_of(joint.parent), to, X, tag, of_pose, false);
    if (joint.type != Joint::Type::fixed) {
      axis_line(joint, axis);
      limit(joint, axis, joint.type == Joint::Type::prismatic);
      dynamics(joint, axis);
      mimic(joint, axis);
    }
    xml_.close();
  }

  void two_axes(const Joint& joint, const std::string& to, const Pose& X, const Place& of_pose) {
    const Place tag = tag_of(joint.vertex->element, joint.vertex->scope->frame);
    const std::string between = links_.add(to + "__" + joint.vertex->name + "_1");
    for (std::size_t i = 0; i < 2; ++i) {
      const bool is_first = i == 0;
      const Axis& axis = joint.axes[i];
      open_joint(is_first ? joint.name : joints_.add(joint.name + "_2"),
                 name_place(*joint.vertex, is_first ? joint.name : ""), type_of(joint, axis),
                 is_first ? name_of(joint.parent) : between, is_first ? between : to,
                 is_first ? X : Pose{}, tag, of_pose, !is_first);
      axis_line(joint, axis);
      limit(joint, axis, false);
      dynamics(joint, axis);
      mimic(joint, axis);
      xml_.close();
      if (is_first) add_made_link(xml_, between, tag);
      of_parent_ = tag;
    }
  }

  void ball(const Joint& joint, const std::string& to, const Pose& X, const Place& of_pose) {
    const Place tag = tag_of(joint.vertex->element, joint.vertex->scope->frame);
    constexpr std::pair<std::string_view, std::string_view> kAxes[] = {
        {"_x", "1 0 0"}, {"_y", "0 1 0"}, {"_z", "0 0 1"}};
    std::string from = name_of(joint.parent);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string suffix(kAxes[i].first);
      const std::string child = i == 2 ? to : links_.add(to + "__" + joint.vertex->name + suffix);
      open_joint(joints_.add(joint.name + suffix), tag, "continuous", from, child,
                 i == 0 ? X : Pose{}, tag, of_pose, true);
      xml_.open("axis", tag);
      xml_.attribute("xyz", kAxes[i].second, tag);
      xml_.close();
      xml_.close();
      if (i < 2) add_made_link(xml_, child, tag);
      from = child;
      of_parent_ = tag;
    }
  }

  /// A turn, and a slide that follows it.
  void screw(const Joint& joint, const std::string& to, const Pose& X, const Place& of_pose) {
    const Axis& axis = joint.axes[0];
    const View element = joint.vertex->element;
    const xacro::FrameId frame = joint.vertex->scope->frame;
    const Place tag = tag_of(element, frame);
    const std::string between = links_.add(to + "__" + joint.vertex->name + "_1");
    open_joint(joint.name, name_place(*joint.vertex, joint.name), type_of(joint, axis),
               name_of(joint.parent), between, X, tag, of_pose, false);
    axis_line(joint, axis);
    limit(joint, axis, false);
    dynamics(joint, axis);
    xml_.close();
    add_made_link(xml_, between, tag);
    of_parent_ = tag;
    open_joint(joints_.add(joint.name + "_2"), tag, "prismatic", between, to, {}, tag, of_pose,
               true);
    axis_line(joint, axis);
    limit(joint, Axis{}, true);
    const std::string_view pitch =
        element.child("screw_thread_pitch") ? "screw_thread_pitch" : "thread_pitch";
    xml_.open("mimic", tag);
    xml_.attribute("joint", joint.name, tag);
    xml_.number("multiplier", joint.travel, place_in(element, pitch, frame));
    xml_.close();
    xml_.close();
  }

  Model& model_;
  Reporter& reporter_;
  TracedXml xml_;
  ShapeWriter shapes_;
  ExtensionWriter extensions_;
  Frames frames_;
  UniqueNames links_, joints_;
  std::map<const Vertex*, const Joint*> joint_of_;
  std::vector<const Joint*> holders_;  ///< by link; null: none
  Place of_type_, of_parent_, of_child_;
};

}  // namespace

std::optional<LinkIndex> root_of(const Model& model) {
  if (model.scopes.front().is_world) return std::nullopt;
  std::vector<bool> is_held(model.links.size(), false);
  for (const Joint& joint : model.joints) {
    if (!joint.is_in_tree) continue;
    if (!joint.parent.link) return std::nullopt;
    is_held[*joint.child.link] = true;
  }
  // One tree that may move is the robot itself; what an entity stands on is said by its anchor.
  const auto root = std::find(is_held.begin(), is_held.end(), false);
  if (root == is_held.end() || std::find(root + 1, is_held.end(), false) != is_held.end())
    return std::nullopt;
  const auto index = static_cast<LinkIndex>(root - is_held.begin());
  if (model.links[index].is_static && !model.is_entity) return std::nullopt;
  return index;
}

std::string write_robot(Model& model, Files& files, Reporter& reporter,
                        xacro::Expansion& expansion) {
  return RobotWriter(model, files, reporter, expansion).run();
}

}  // namespace smurf::sdformat
