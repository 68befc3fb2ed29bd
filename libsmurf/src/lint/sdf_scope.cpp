// SPDX-License-Identifier: BSD-3-Clause
// Sources: sdformat 12.3.0 src/parser_urdf.cc (where the elements go), Model.cc, FrameSemantics.cc
// and parser.cc:2150-2290 (names).
#include "lint/sdf_scope.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/text/quoted.hpp"
#include "readers/rigid_bodies.hpp"
#include "readers/sdf_language.hpp"
#include "readers/sdf_values.hpp"
#include "verdict/targets.hpp"

namespace smurf::sdf {
namespace {

/// The names of a model, each with the name that its frame hangs on; empty for the model's own.
class Scope {
 public:
  explicit Scope(const Report& report) : report_(report) {}

  void add_link(std::string_view name) { add(name, "link", ""); }
  void add_joint(std::string_view name, std::string_view child) { add(name, "joint", child); }
  /// What is no more, because links on fixed joints become one.
  void add_merged(std::string_view name) { merged_.insert(name); }

  /// Reports what is wrong with the names and references in these children of a model.
  void check(const std::vector<xml::View>& elements) {
    for (const xml::View element : elements) define(element);
    for (const xml::View element : elements) refer(element);
    for (const xml::View element : elements) check_ring(element);
  }
  bool has_links() const { return has_links_; }

 private:
  struct Frame {
    std::string_view kind, base;
  };

  void add(std::string_view name, std::string_view kind, std::string_view base) {
    frames_.emplace(name, Frame{kind, base});
    has_links_ = has_links_ || kind == "link" || kind == "model";
  }

  static bool is_frame(xml::View element) {
    const std::string_view kind = element.name();
    return kind == "link" || kind == "joint" || kind == "frame" || kind == "model";
  }
  static std::string_view relative_to(xml::View element) {
    const xml::View pose = element.child("pose");
    return pose ? value_of(pose, "relative_to") : std::string_view();
  }

  void define(xml::View element) {
    const std::string_view name = value_of(element, "name");
    if (!is_frame(element) || name.empty()) return;
    check_reserved(element, report_);
    const auto known = frames_.find(name);
    if (known != frames_.end()) {
      report_(place_of(element, "name"),
              "a " + std::string(known->second.kind) + " is called " + quoted(name) + ", too");
      return;
    }
    const std::string_view kind = element.name();
    std::string_view base = relative_to(element);
    if (kind == "frame" && base.empty()) base = value_of(element, "attached_to");
    if (kind == "joint" && base.empty()) base = text_of(element, "child");
    add(name, kind, base);
  }

  bool is_known(std::string_view name) const {
    const std::size_t nested = name.find("::");  // in a model of this one
    if (nested == std::string_view::npos) return name == "__model__" || frames_.contains(name);
    const auto model = frames_.find(name.substr(0, nested));
    return model != frames_.end() && model->second.kind == "model";
  }

  void refer(Span place, std::string_view name) {
    if (name.empty() || is_known(name)) return;
    Diagnostic& found = report_(place, "Gazebo finds no link, joint or frame " + quoted(name));
    if (merged_.contains(name)) found.when(kMerged);
  }

  void refer(xml::View element) {
    if (!is_frame(element)) return;
    if (const xml::View pose = element.child("pose")) {
      refer(place_of(pose, "relative_to"), value_of(pose, "relative_to"));
    }
    if (element.name() == "frame") {
      refer(place_of(element, "attached_to"), value_of(element, "attached_to"));
    } else if (element.name() == "joint") {
      refer_to_ends(element);
    }
  }

  void refer_to_ends(xml::View joint) {
    const xml::View parent = joint.child("parent"), child = joint.child("child");
    if (!parent || !child) return;
    const std::string_view above = trimmed_text(parent.text()), below = trimmed_text(child.text());
    if (above != "world") refer(place_of(parent), above);
    if (below == "world") {
      report_(place_of(child), "Gazebo refuses `world` as a child");
    } else {
      refer(place_of(child), below);
    }
    const std::string_view name = value_of(joint, "name");
    if (above == name || below == name) {
      report_(joint.name_span(), "the joint names itself");
    } else if (!below.empty() && link_of(above) == link_of(below)) {
      report_(place_of(child), "the parent and the child are one link");
    }
  }

  /// The link that a frame is attached to.
  std::string_view link_of(std::string_view name) const {
    for (std::size_t i = 0; i <= frames_.size(); ++i) {
      const auto frame = frames_.find(name);
      if (frame == frames_.end() || frame->second.base.empty() || frame->second.kind == "link") {
        return name;
      }
      name = frame->second.base;
    }
    return name;
  }

  void check_ring(xml::View element) {
    if (!is_frame(element)) return;
    const std::string_view start = value_of(element, "name");
    std::string_view name = start;
    for (std::size_t i = 0; i <= frames_.size(); ++i) {
      const auto frame = frames_.find(name);
      if (frame == frames_.end() || frame->second.base.empty()) return;
      name = frame->second.base;
      if (name != start) continue;
      report_(place_of(element, "name"), "the frame hangs on itself");
      return;
    }
  }

  const Report& report_;
  std::map<std::string_view, Frame> frames_;
  std::set<std::string_view> merged_;
  bool has_links_ = false;
};

std::string_view name_of(const Field<std::string>& name) {
  return name ? std::string_view(*name) : std::string_view();
}

std::vector<xml::View> children_of(xml::View parent) {
  std::vector<xml::View> children;
  for (const xml::View child : parent) children.push_back(child);
  return children;
}

double number_of(xml::View parent, std::string_view child, double otherwise) {
  const std::string_view text = parent ? text_of(parent, child) : std::string_view();
  return text.empty() ? otherwise : leading_number(text).value_or(otherwise);
}

/// The inertial of a link written in SDF.
void check_inertia(xml::View link, const Report& report) {
  const xml::View inertial = link.child("inertial");
  if (!inertial) return;
  const xml::View inertia = inertial.child("inertia");
  const auto moment = [&](const char* name) { return number_of(inertia, name, 1); };
  const auto product = [&](const char* name) { return number_of(inertia, name, 0); };
  if (is_inertia_of_sdformat(number_of(inertial, "mass", 1),
                             {moment("ixx"), moment("iyy"), moment("izz")},
                             {product("ixy"), product("ixz"), product("iyz")})) {
    return;
  }
  report(inertial.name_span(), "no body has such an inertial");
}

/// Shapes, sensors and lights of one link have names of their own.
void check_parts(const std::vector<xml::View>& parts, const Report& report) {
  std::map<std::pair<std::string_view, std::string_view>, xml::View> seen;
  for (const xml::View part : parts) {
    const std::string_view kind = part.name(), name = value_of(part, "name");
    const bool has_own_name = kind == "sensor" || kind == "light" || kind == "visual" ||
                              kind == "collision" || kind == "particle_emitter";
    if (!has_own_name || name.empty()) continue;
    const auto [first, is_new] = seen.try_emplace({kind, name}, part);
    if (is_new) continue;
    Diagnostic& found = report(place_of(part, "name"), "a second " + std::string(kind) + " " +
                                                           quoted(name) + " of one link");
    if (value_of(first->second.parent(), "reference") != value_of(part.parent(), "reference"))
      found.when(kMerged);
  }
}

void check_link(xml::View link, const Report& report) {
  check_inertia(link, report);
  check_parts(children_of(link), report);
}

// The recursion is as deep as the file, whose depth is limited.
void check_model(xml::View model, const Report& report) {
  Scope scope(report);
  const std::vector<xml::View> children = children_of(model);
  scope.check(children);
  const std::string_view is_static = text_of(model, "static");
  if (!scope.has_links() && is_static != "true" && is_static != "1") {
    report(model.name_span(), "the model has no link");
  }
  for (const xml::View child : children) {
    if (child.name() == "link") check_link(child, report);
    if (child.name() == "model") check_model(child, report);
  }
}

/// The extensions of one robot.
class Extensions {
 public:
  Extensions(const LinkedModel& model, const Report& report)
      : model_(model), report_(report), links_(links_of_sdformat(model)) {
    // Without any link the model is refused for another reason; this says what else is wrong.
    if (!is_left_without_links(model)) return;
    for (std::uint32_t i = 0; i < links_.size(); ++i) links_[i] = LinkIndex{i};
  }

  void check() {
    for (const xml::ElementId id : model_.robot->extensions) {
      const xml::View gazebo(model_.robot->document, id);
      if (gazebo.name() != "gazebo") continue;
      const xml::Attribute* reference = gazebo.attribute("reference");
      if (reference == nullptr || reference->value().empty()) {
        add_to_model(gazebo);
      } else {
        add_to_link(gazebo, reference->value());
        add_to_joint(gazebo, reference->value());
      }
    }
    for (const auto& [link, parts] : parts_) check_parts(parts, report_);
    check_names();
  }

 private:
  void element(xml::View element, std::string_view kind) {
    if (element.name() == "include") return check_include(element, report_);
    const Element* row = find(kind);
    const auto part = find_part(row->children, element.name());
    if (part && part->value != '\0' && !is_readable(*part, element.text(), element)) {
      report_unreadable(place_of(element), part->name, trimmed_text(element.text()).empty(),
                        wanted(*part), report_);
    } else if (part && !part->kind.empty()) {
      check_element(element, part->kind, report_);
    }
  }

  void add_to_model(xml::View gazebo) {
    for (const xml::View child : gazebo) {
      if (is_translated(child.name())) continue;
      element(child, "model");
      added_.push_back(child);
      if (child.name() == "pose" && !value_of(child, "relative_to").empty()) {
        report_(place_of(child, "relative_to"), "the pose of a model is relative to nothing");
      }
      if (child.name() == "link") check_link(child, report_);
      if (child.name() == "model") check_model(child, report_);
    }
  }

  void add_to_link(xml::View gazebo, std::string_view name) {
    const auto index = model_.link_names.find(name);
    if (!index || !links_[*index]) return;
    const urdf::Link& link = model_.robot->links[*index];
    for (const xml::View child : gazebo) {
      const std::string_view kind = child.name();
      if (kind == "visual" || kind == "collision") {
        // It goes into every shape of the link.
        const bool has_shape = kind == "visual" ? !link.visuals.empty() : !link.collisions.empty();
        if (has_shape) check_children(child, kind, report_);
      } else if (!is_translated(kind)) {
        const bool is_moved = to_size(*links_[*index]) != *index;
        is_moved ? moved_element(child) : element(child, "link");
        parts_[to_size(*links_[*index])].push_back(child);
      }
    }
  }

  /// In a link that sdformat joins with another, it writes the first pose of a sensor or projector
  /// again, whatever it was (libsdformat 12.3, run).
  void moved_element(xml::View part) {
    const bool has_moved_pose = part.name() == "sensor" || part.name() == "projector";
    const xml::View pose = has_moved_pose ? part.child("pose") : xml::View();
    if (!pose || pose.attribute("relative_to") != nullptr) return element(part, "link");
    const Span moved = pose.span();
    const Report report = [&](Span place, std::string message) -> Diagnostic& {
      Diagnostic& found = report_(place, std::move(message));
      if (moved.begin <= place.begin && place.end <= moved.end) found.when(kMovedPose);
      return found;
    };
    check_element(part, part.name(), report);
  }

  bool is_kept(JointIndex joint) const {
    const std::optional<LinkIndex> child = model_.tree.joint_child[to_size(joint)];
    return child && links_[to_size(*child)] == child;
  }

  void add_to_joint(xml::View gazebo, std::string_view name) {
    const auto index = model_.joint_names.find(name);
    if (!index || !is_kept(JointIndex{*index})) return;
    std::vector<xml::View> parts;
    for (const xml::View child : gazebo) {
      if (is_translated(child.name())) continue;
      element(child, "joint");
      parts.push_back(child);
    }
    check_parts(parts, report_);
  }

  void check_names() {
    Scope scope(report_);
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const bool is_link = links_[i] && to_size(*links_[i]) == i;
      const std::string_view name = name_of(model_.robot->links[i].name);
      is_link ? scope.add_link(name) : scope.add_merged(name);
    }
    for (std::uint32_t i = 0; i < model_.robot->joints.size(); ++i) {
      const std::string_view name = name_of(model_.robot->joints[i].name);
      if (!is_kept(JointIndex{i})) {
        scope.add_merged(name);
        continue;
      }
      const std::optional<LinkIndex> child = model_.tree.joint_child[i];
      scope.add_joint(name, name_of(model_.link(*child).name));
    }
    scope.check(added_);
  }

  const LinkedModel& model_;
  const Report& report_;
  std::vector<std::optional<LinkIndex>> links_;
  std::map<std::size_t, std::vector<xml::View>> parts_;  ///< by link, in the order of the file
  std::vector<xml::View> added_;                         ///< to the model
};

}  // namespace

void check_extensions(const LinkedModel& model, const Report& report) {
  Extensions(model, report).check();
}

}  // namespace smurf::sdf
