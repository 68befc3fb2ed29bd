// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/extensions.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "imports/joint_xml.hpp"
#include "sdf/shapes.hpp"

namespace smurf::sdformat {
namespace {

/// Elements of a link that readers of a URDF take from `<gazebo>` as they are.
constexpr std::string_view kOfLink[] = {"sensor",           "gravity",     "self_collide",
                                        "kinematic",        "enable_wind", "velocity_decay",
                                        "must_be_base_link"};
/// Elements that have no place in a URDF.
constexpr std::string_view kLost[] = {"light",   "projector", "audio_source",     "audio_sink",
                                      "battery", "gripper",   "particle_emitter", "actor",
                                      "road",    "population"};

/// Elements of visuals and collisions that readers of a URDF take from `<gazebo>`, too.
constexpr std::string_view kOfShape[] = {"surface",      "max_contacts",     "laser_retro",
                                         "cast_shadows", "visibility_flags", "plugin"};

bool are_equal(const View& one, const View& other) {
  const auto some = one.attributes();
  const auto others = other.attributes();
  const auto is_same = [](const Attribute& a, const Attribute& b) {
    return a.name() == b.name() && a.value() == b.value();
  };
  if (one.name() != other.name() || text_of(one) != text_of(other) ||
      !std::equal(some.begin(), some.end(), others.begin(), others.end(), is_same)) {
    return false;
  }
  std::vector<View> children;
  std::vector<View> other_children;
  for (const View child : one) children.push_back(child);
  for (const View child : other) other_children.push_back(child);
  return std::equal(children.begin(), children.end(), other_children.begin(), other_children.end(),
                    are_equal);
}

template <std::size_t N>
bool is_among(std::string_view text, const std::string_view (&texts)[N]) {
  return std::find(std::begin(texts), std::end(texts), text) != std::end(texts);
}

}  // namespace

void ExtensionWriter::write_all() {
  model_settings();
  for (const Link& link : model_.links) write(link);
  for (const Joint& joint : model_.joints) {
    if (joint.is_in_tree) write(joint);
    if (joint.closes_loop) loop(joint);
  }
  for (const Scope& scope : model_.scopes) losses(scope);
}

void ExtensionWriter::lost(View element) {
  reporter_
      .lose(element.name_span(),
            "a URDF has no " + quoted(element.name()) + ", so this one is lost", "lost elements")
      .help("keep the SDF for it");
}

void ExtensionWriter::losses(const Scope& scope) {
  for (const View one : scope.element) {
    if (is_among(one.name(), kLost)) lost(one);
  }
  if (!scope.is_world) return;
  View second;
  std::size_t count = 0;
  for (const View one : scope.element) {
    if (one.name() != "model" && one.name() != "include") continue;
    if (++count == 2) second = one;
  }
  if (!second) return;
  reporter_
      .report(rules::sml9304_lost_in_urdf, second.name_span(),
              "a URDF is one robot, so all models of the world become parts of it, on the link "
              "`world`")
      .help("name a file with one `<model>` for a robot alone");
}

void ExtensionWriter::model_settings() {
  bool is_open = false;
  for (const Scope& scope : model_.scopes) {
    if (scope.is_world) continue;
    const bool is_robot = scope.outer == nullptr || scope.is_merged;
    bool is_first = true;
    for (const View one : scope.element) {
      const bool is_plugin = one.name() == "plugin";
      if (!is_plugin && (one.name() != "self_collide" || !is_robot)) continue;
      if (is_robot) {
        if (!is_open) xml_.open("gazebo", tag_of(scope.element, scope.frame));
        is_open = true;
        copy(one, scope.frame, nullptr);
      } else if (is_first) {
        reporter_
            .report(rules::sml9304_lost_in_urdf, one.name_span(),
                    "a plugin of a URDF is one of the whole robot, so those of " +
                        quoted(scope.name) + " are lost")
            .help("keep the SDF for them");
        is_first = false;
      }
    }
  }
  if (is_open) xml_.close();
}

void ExtensionWriter::write(const Link& link) {
  const View element = link.vertex->element;
  const xacro::FrameId frame = link.vertex->scope->frame;
  bool is_open = false;
  for (const View one : element) {
    if (is_among(one.name(), kLost)) lost(one);
    if (!is_among(one.name(), kOfLink)) continue;
    open(link, is_open);
    copy(one, frame, &link);
  }
  shapes(link, "visual", is_open);
  shapes(link, "collision", is_open);
  if (is_open) xml_.close();
}

void ExtensionWriter::open(const Link& link, bool& is_open) {
  if (!is_open) {
    const Place tag = tag_of(link.vertex->element, link.vertex->scope->frame);
    xml_.open("gazebo", tag);
    xml_.attribute("reference", link.name, tag);
  }
  is_open = true;
}

/// A `<gazebo>` has one `<visual>` for all visuals of a link, and one `<collision>` for all its
/// collisions.
void ExtensionWriter::shapes(const Link& link, std::string_view kind, bool& is_open) {
  std::vector<std::vector<View>> all;  // the settings of each shape
  View first;
  for (const View shape : link.vertex->element) {
    if (shape.name() != kind) continue;
    std::vector<View>& settings = all.emplace_back();
    for (const View one : shape) {
      if (is_among(one.name(), kOfShape)) settings.push_back(one);
    }
    if (!first && !settings.empty()) first = settings.front();
  }
  if (!first) return;
  const auto is_same = [&](const std::vector<View>& some) {
    return std::equal(some.begin(), some.end(), all.front().begin(), all.front().end(), are_equal);
  };
  if (!std::all_of(all.begin(), all.end(), is_same)) {
    reporter_
        .lose(first.name_span(),
              "a URDF has settings such as " + quoted(first.name()) + " for all " +
                  std::string(kind) + "s of a link together, and those of " + quoted(link.name) +
                  " differ, so they are lost",
              "lost settings of shapes")
        .help("keep the SDF for them");
    return;
  }
  open(link, is_open);
  xml_.open(kind, tag_of(first.parent(), link.vertex->scope->frame));
  for (const View one : all.front()) copy(one, link.vertex->scope->frame, nullptr);
  xml_.close();
}

void ExtensionWriter::write(const Joint& joint) {
  const View element = joint.vertex->element;
  const xacro::FrameId frame = joint.vertex->scope->frame;
  const View axis = joint.axes[0].element;
  const View dynamics = axis ? axis.child("dynamics") : View();
  const double stiffness = number_in(dynamics, "spring_stiffness", 0);
  const bool has_sensor = static_cast<bool>(element.child("sensor"));
  if (stiffness == 0 && !has_sensor) return;
  const Place tag = tag_of(element, frame);
  xml_.open("gazebo", tag);
  xml_.attribute("reference", joint.name, tag);
  for (const View one : element) {
    if (one.name() == "sensor") copy(one, frame, nullptr);
  }
  if (stiffness != 0) {
    const auto number = [&](std::string_view name, std::string_view of, double value) {
      xml_.open(name, tag_of(dynamics, frame));
      xml_.text(format_number(value), place_in(dynamics, of, frame));
      xml_.close();
    };
    number("springStiffness", "spring_stiffness", stiffness);
    number("springReference", "spring_reference", number_in(dynamics, "spring_reference", 0));
  }
  xml_.close();
}

/// A joint beside the tree, whose pose is that in its child.
void ExtensionWriter::loop(const Joint& joint) {
  const View element = joint.vertex->element;
  const xacro::FrameId frame = joint.vertex->scope->frame;
  const Place tag = tag_of(element, frame);
  const Link& child = model_.links[*joint.child.link];
  const Pose X_CJ = joint.is_at_child ? Pose{} : inverse(child.X_W) * joint.X_W;
  const bool is_free = joint.type != Joint::Type::fixed && joint.type != Joint::Type::ball;
  imports::JointText text{.name = joint.name,
                          .type = is_free                           ? "revolute"
                                  : joint.type == Joint::Type::ball ? "ball"
                                                                    : "fixed",
                          .parent = model_.links[*joint.parent.link].name,
                          .child = child.name,
                          .tag = tag,
                          .of_name = tag,
                          .of_type = tag,
                          .of_parent = place_in(element, "parent", frame),
                          .of_child = place_in(element, "child", frame),
                          .of_pose = place_in(element, "pose", frame)};
  open_loop(xml_, text, X_CJ);
  const Axis& axis = joint.axes[0];
  if (axis.element && is_free) {
    xml_.open("axis", tag_of(axis.element, frame));
    add_leaf(xml_, "xyz", words_of(axis.xyz), place_in(axis.element, "xyz", frame));
    for (const View one : axis.element) {
      if (one.name() == "limit" || one.name() == "dynamics") copy(one, frame, nullptr);
    }
    xml_.close();
  }
  xml_.close();
  xml_.close();
}

/// Gazebo reads prefixes that nothing declares, and readers of XML with namespaces do not.
void ExtensionWriter::declare(View element, const Place& tag) {
  const auto declare_one = [&](std::string_view name) {
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos || name.starts_with("xmlns")) return;
    const std::string key = "xmlns:" + std::string(name.substr(0, colon));
    if (element.attribute(key) != nullptr) return;  // copied with the others
    std::string_view uri = "http://gazebosim.org/schema";
    for (View at = element; at; at = at.parent()) {
      if (const Attribute* one = at.attribute(key)) uri = one->value();
    }
    if (std::find(declared_.begin(), declared_.end(), key) != declared_.end()) return;
    declared_.push_back(key);
    xml_.attribute(key, uri, tag, true);
  };
  declared_.clear();
  declare_one(element.name());
  for (const Attribute& one : element.attributes()) declare_one(one.name());
}

void ExtensionWriter::copy(View element, xacro::FrameId frame, const Link* link) {
  if (xml_.is_full()) return;
  const Place tag = tag_of(element, frame);
  const bool is_pose = link != nullptr && element.name() == "pose";
  xml_.open(element.name(), tag);
  declare(element, tag);
  if (!is_pose) {
    for (const Attribute& one : element.attributes()) {
      xml_.attribute(one.name(), one.value(), {one.value_span(), element.tag_span(), frame, true});
    }
  }
  if (is_pose && !element.attributes().empty()) {
    // A URDF knows no frames, degrees or quaternions here.
    const Pose X = pose_of_shape(element.parent(), *link, frames_);
    xml_.text(words_of(X.position) + " " + words_of(to_rpy(X.orientation)),
              place_of(element, frame));
  } else if (!text_of(element).empty()) {
    Place place = place_of(element, frame);
    place.is_exact = true;
    xml_.text(text_of(element), place);
  }
  for (const View child : element) copy(child, frame, link);
  xml_.close();
}

}  // namespace smurf::sdformat
