// SPDX-License-Identifier: BSD-3-Clause
#include "write/parts/gazebo_elements.hpp"

#include <algorithm>
#include <array>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "convert/import.hpp"
#include "write/sdf/sdf_names.hpp"
#include "write/text/raw_xml.hpp"

namespace smurf {
namespace {

/// Elements that become parts of the link, its shapes or the joint.
constexpr std::string_view kOfLinks[] = {
    "mu1",       "mu2",           "fdir1",         "kp",          "kd",       "maxVel",
    "minDepth",  "maxContacts",   "laserRetro",    "selfCollide", "material", "visual",
    "collision", "dampingFactor", "turnGravityOff"};
/// Elements that only become parts of collisions, and of visuals.
constexpr std::string_view kOfCollisions[] = {"mu1",    "mu2",      "fdir1",       "kp",       "kd",
                                              "maxVel", "minDepth", "maxContacts", "collision"};
constexpr std::string_view kOfVisuals[] = {"material", "visual"};
constexpr std::string_view kOfJoints[] = {"stopCfm",
                                          "stopErp",
                                          "fudgeFactor",
                                          "provideFeedback",
                                          "cfmDamping",
                                          "springStiffness",
                                          "implicitSpringDamper",
                                          "springReference",
                                          "preserveFixedJoint",
                                          "disableFixedJointLumping",
                                          "disableJointLumping"};

template <std::size_t size>
bool is_one_of(std::string_view name, const std::string_view (&names)[size]) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Types that libsdformat reads as numbers or vectors; a reader may refuse other texts.
constexpr std::string_view kNumbers[] = {"mu1",
                                         "mu2",
                                         "kp",
                                         "kd",
                                         "maxVel",
                                         "minDepth",
                                         "maxContacts",
                                         "laserRetro",
                                         "dampingFactor",
                                         "stopCfm",
                                         "stopErp",
                                         "fudgeFactor",
                                         "springStiffness",
                                         "springReference"};
constexpr std::string_view kVectors[] = {"fdir1"};
constexpr std::string_view kFlags[] = {"selfCollide", "turnGravityOff", "cfmDamping",
                                       "provideFeedback", "implicitSpringDamper"};

bool is_true(std::string_view text) { return text == "true" || text == "1" || text == "True"; }

/// The value of an element, which is its text or its attribute `value`.
std::string_view value_of(xml::View element) {
  const std::string_view text = import::text_of(element);
  return text.empty() ? attribute_of(element, "value") : text;
}

/// Whether SDF has the joint: none of its links is written as a frame.
bool is_joint_of_sdf(const LinkedModel& model, std::uint32_t joint) {
  if (model.robot->joints[joint].type != urdf::JointType::fixed) return true;
  const auto& child = model.tree.joint_child[joint];
  return child && model.link(*child).inertial && model.link(*child).inertial->mass &&
         *model.link(*child).inertial->mass > 0;
}

template <std::size_t size>
std::optional<std::array<double, size>> parse_numbers(std::string_view text) {
  std::array<double, size> numbers{};
  for (double& number : numbers) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    text.remove_prefix(begin);
    const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    const auto value = parse_number(text.substr(0, end));
    if (!value) return std::nullopt;
    number = *value;
    text.remove_prefix(end);
  }
  return numbers;
}

/// Six numbers of a pose: x y z roll pitch yaw.
std::optional<Pose> parse_pose(std::string_view text) {
  const auto numbers = parse_numbers<6>(text);
  if (!numbers) return std::nullopt;
  const auto& [x, y, z, roll, pitch, yaw] = *numbers;
  return Pose{{x, y, z}, from_rpy({roll, pitch, yaw})};
}

/// Whether an element has a value of its type. An element without a value is valid.
bool is_sound(std::string_view name, std::string_view value) {
  if (value.empty()) return true;
  if (is_one_of(name, kNumbers)) return parse_numbers<1>(value).has_value();
  if (is_one_of(name, kVectors)) return parse_numbers<3>(value).has_value();
  constexpr std::string_view kFlagValues[] = {"true", "false", "yes", "no", "1", "0"};
  return !is_one_of(name, kFlags) || is_one_of(path::to_lower(value), kFlagValues);
}

/// SDF refuses a plug-in without a file.
bool is_broken_plugin(xml::View element) {
  return element.name() == "plugin" && attribute_of(element, "filename").empty();
}

/// Whether a link has the shapes that an element in its <gazebo> is about.
bool has_shapes_for(const urdf::Link& link, std::string_view element) {
  if (is_one_of(element, kOfCollisions)) return !link.collisions.empty();
  return !is_one_of(element, kOfVisuals) || !link.visuals.empty();
}

}  // namespace

bool touches_itself(const LinkedModel& model) {
  if (!model.robot) return false;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) {
      const bool is_asked = is_one_of(child.name(), {"selfCollide", "self_collide"});
      if (is_asked && is_true(value_of(child))) return true;
    }
  }
  return false;
}

bool is_taken_by_gazebo(const LinkedModel& model, xml::View child) {
  const bool needs_name = child.name() == "sensor" || child.name() == "plugin";
  if (needs_name && attribute_of(child, "name").empty()) return false;
  if (is_broken_plugin(child)) return false;
  const std::string_view reference = attribute_of(child.parent(), "reference");
  if (!reference.empty() && !is_sound(child.name(), value_of(child))) return false;
  if (reference.empty()) return child.name().find(':') == std::string_view::npos;
  const bool is_of_joint = is_one_of(child.name(), kOfJoints);
  const auto link = model.link_names.find(reference);
  if (link && !is_of_joint) return has_shapes_for(model.robot->links[*link], child.name());
  const auto joint = model.joint_names.find(reference);
  return joint && is_joint_of_sdf(model, *joint) && !is_one_of(child.name(), kOfLinks);
}

bool is_of_spring(const LinkedModel& model, xml::View child) {
  if (child.name() != "springStiffness" && child.name() != "springReference") return false;
  const auto joint = model.joint_names.find(attribute_of(child.parent(), "reference"));
  return joint && model.robot->joints[*joint].has_one_axis() &&
         parse_numbers<1>(value_of(child)).has_value();
}

std::map<std::string_view, JointSpring> springs_of(const LinkedModel& model) {
  std::map<std::string_view, JointSpring> springs;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) {
      if (!is_of_spring(model, child)) continue;
      JointSpring& spring = springs[attribute_of(gazebo, "reference")];
      const double value = parse_numbers<1>(value_of(child))->front();
      (child.name() == "springStiffness" ? spring.stiffness : spring.reference) = value;
    }
  }
  return springs;
}

std::vector<xml::View> broken_plugins(xml::View sensor) {
  std::vector<xml::View> found;
  if (sensor.name() != "sensor") return found;
  for (const xml::View child : sensor) {
    if (is_broken_plugin(child)) found.push_back(child);
  }
  return found;
}

GazeboElements::GazeboElements(const LinkedModel& model, std::string_view source)
    : model_(model), source_(source) {
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) {
      if (!is_taken_by_gazebo(model, child)) continue;
      Part& part = by_reference_[std::string(attribute_of(gazebo, "reference"))];
      part.elements.push_back(child);
      part.values[child.name()] = value_of(child);
      if (child.name() == "visual") part.visuals.push_back(child);
      if (child.name() == "collision") part.collisions.push_back(child);
      part.has_material |= child.name() == "visual" && child.child("material");
    }
  }
}

void GazeboElements::move(xml::ElementId element, std::string_view from, const std::string& to) {
  const auto old = by_reference_.find(from);
  if (old == by_reference_.end()) return;
  std::vector<xml::View>& elements = old->second.elements;
  const auto found = std::find_if(elements.begin(), elements.end(),
                                  [&](const xml::View& one) { return one.id() == element; });
  if (found == elements.end()) return;
  by_reference_[to].elements.push_back(*found);
  by_reference_.find(from)->second.elements.erase(found);
}

const GazeboElements::Part& GazeboElements::part_of(std::string_view reference) const {
  static const Part kNone;
  const auto found = by_reference_.find(reference);
  return found == by_reference_.end() ? kNone : found->second;
}

std::string_view GazeboElements::value(std::string_view reference, std::string_view name) const {
  const auto& values = part_of(reference).values;
  const auto found = values.find(name);
  return found == values.end() ? std::string_view() : found->second;
}

bool GazeboElements::has_any(std::string_view reference,
                             std::initializer_list<std::string_view> names) const {
  return std::any_of(names.begin(), names.end(),
                     [&](std::string_view name) { return !value(reference, name).empty(); });
}

void GazeboElements::leaf(XmlText& xml, std::string_view reference, std::string_view name,
                          std::string_view written_as) const {
  if (const std::string_view text = value(reference, name); !text.empty()) {
    xml.leaf(written_as, text);
  }
}

void GazeboElements::add_raw(XmlText& xml, xml::View element, std::string_view frame,
                             const Pose& X_BL, UniqueNames& names) const {
  std::vector<Edit> edits;
  const auto insert = [&](const Span& at, std::string text) {
    edits.push_back({{at.source, at.end, at.end}, std::move(text)});
  };
  if (const xml::Attribute* name = element.attribute("name");
      name != nullptr && element.name() == "sensor") {
    const std::string unique = names.add(sdf_name(name->value()));
    if (unique != name->value()) edits.push_back({name->value_span(), escape_xml(unique)});
  }
  for (const xml::View part : element) {
    for (const xml::View inner : part) {
      const auto changed = texts_.find(inner.id());
      if (changed == texts_.end()) continue;
      for (const auto& [span, text] : changed->second) edits.push_back({span, escape_xml(text)});
    }
  }
  for (const xml::View plugin : broken_plugins(element)) edits.push_back({plugin.span(), ""});
  const xml::View pose = element.child("pose");
  const bool is_placed =
      element.name() == "sensor" || element.name() == "projector" || element.name() == "light";
  if (is_placed && X_BL != Pose{} && !(pose && pose.attribute("relative_to") != nullptr)) {
    const auto text = [](const Pose& X) {
      return join_numbers(X.position) + " " + join_numbers(to_rpy(X.orientation));
    };
    if (!pose) {
      const bool has_end_tag = element.tag_span().end < element.span().end;
      const std::string attribute =
          frame.empty() ? "" : " relative_to=\"" + escape_xml(frame) + "\"";
      const std::string line =
          "<pose" + attribute + ">" + text(frame.empty() ? X_BL : Pose{}) + "</pose>";
      if (has_end_tag) insert(element.tag_span(), line);
    } else if (!frame.empty()) {
      insert(pose.name_span(), " relative_to=\"" + escape_xml(frame) + "\"");
    } else if (const auto X_LS = parse_pose(import::text_of(pose))) {
      edits.push_back({pose.text_span(), text(X_BL * *X_LS)});
    }
  }
  if (!xml.is_full()) xml.raw(raw_xml(element, source_, std::move(edits)) + "\n");
}

void GazeboElements::add_to_model(XmlText& xml) const {
  UniqueNames none;
  for (const xml::View element : of({})) {
    if (has_own_contacts_ || element.name() != "self_collide") add_raw(xml, element, {}, {}, none);
  }
}

void GazeboElements::add_to_link(XmlText& xml, std::string_view part, std::string_view frame,
                                 const Pose& X_BL, UniqueNames& names) const {
  for (const xml::View element : of(part)) {
    if (is_one_of(element.name(), kOfLinks)) continue;
    if (has_own_contacts_ || element.name() != "self_collide") {
      add_raw(xml, element, frame, X_BL, names);
    }
  }
  // A part must not set what applies to the whole link.
  if (!frame.empty() || X_BL != Pose{}) return;
  const std::string_view own = value(part, "selfCollide");
  if (has_own_contacts_ && !own.empty()) {
    xml.leaf("self_collide", is_true(own) ? "1" : "0");
  }
  if (const std::string_view text = value(part, "turnGravityOff"); !text.empty()) {
    xml.leaf("gravity", is_true(text) ? "false" : "true");
  }
  if (!has_any(part, {"dampingFactor"})) return;
  xml.open("velocity_decay");
  leaf(xml, part, "dampingFactor", "linear");
  leaf(xml, part, "dampingFactor", "angular");
  xml.close();
}

void GazeboElements::add_children(XmlText& xml, xml::View blob) const {
  for (const xml::View child : blob) {
    if (xml.is_full()) return;
    xml.raw(raw_xml(child, source_) + "\n");
  }
}

void GazeboElements::add_to_collision(XmlText& xml, std::string_view link) const {
  for (const xml::View blob : part_of(link).collisions) add_children(xml, blob);
  leaf(xml, link, "laserRetro", "laser_retro");
  leaf(xml, link, "maxContacts", "max_contacts");
}

void GazeboElements::add_contact(XmlText& xml, std::string_view link) const {
  xml.open("ode");
  leaf(xml, link, "kp", "kp");
  leaf(xml, link, "kd", "kd");
  leaf(xml, link, "maxVel", "max_vel");
  leaf(xml, link, "minDepth", "min_depth");
  xml.close();
}

void GazeboElements::add_friction(XmlText& xml, std::string_view link) const {
  leaf(xml, link, "mu1", "mu");
  leaf(xml, link, "mu2", "mu2");
  leaf(xml, link, "fdir1", "fdir1");
}

void GazeboElements::add_to_visual(XmlText& xml, std::string_view link) const {
  for (const xml::View blob : part_of(link).visuals) add_children(xml, blob);
  leaf(xml, link, "laserRetro", "laser_retro");
}

bool GazeboElements::has_own_material(std::string_view link) const {
  return part_of(link).has_material;
}

void GazeboElements::add_to_dynamics(XmlText& xml, std::string_view joint) const {
  leaf(xml, joint, "springReference", "spring_reference");
  leaf(xml, joint, "springStiffness", "spring_stiffness");
}

void GazeboElements::add_to_joint(XmlText& xml, std::string_view joint, UniqueNames& names) const {
  const bool has_stops = has_any(joint, {"stopCfm", "stopErp"});
  if (has_stops ||
      has_any(joint, {"fudgeFactor", "provideFeedback", "cfmDamping", "implicitSpringDamper"})) {
    xml.open("physics");
    leaf(xml, joint, "provideFeedback", "provide_feedback");
    xml.open("ode");
    leaf(xml, joint, "provideFeedback", "provide_feedback");
    // Two names of the same setting.
    for (const std::string_view name : {"implicitSpringDamper", "cfmDamping"}) {
      leaf(xml, joint, name, "implicit_spring_damper");
      leaf(xml, joint, name, "cfm_damping");
    }
    leaf(xml, joint, "fudgeFactor", "fudge_factor");
    if (has_stops) {
      xml.open("limit");
      leaf(xml, joint, "stopCfm", "cfm");
      leaf(xml, joint, "stopErp", "erp");
      xml.close();
    }
    xml.close();
    xml.close();
  }
  if (model_.link_names.contains(joint)) return;  // they belong to the link of that name
  for (const xml::View element : of(joint)) {
    if (!is_one_of(element.name(), kOfJoints)) add_raw(xml, element, {}, {}, names);
  }
}

}  // namespace smurf
