// SPDX-License-Identifier: BSD-3-Clause
#include "convert/link_references.hpp"

#include <algorithm>

#include "base/text/words.hpp"
#include "convert/gazebo_sensors.hpp"
#include "convert/passes.hpp"
#include "syntax/xml_values.hpp"

namespace smurf {
namespace {

/// Equal texts mean equal elements, independently of their layout.
std::string signature(xml::View element) {
  std::vector<std::string> attributes;
  for (const xml::Attribute& one : element.attributes()) {
    attributes.push_back(std::string(one.name()) + "=" + std::string(one.value()) + "\n");
  }
  std::sort(attributes.begin(), attributes.end());
  std::string text = "<" + std::string(element.name()) + "\n";
  for (const std::string& attribute : attributes) text += attribute;
  text.append(trimmed(element.text()));
  for (const xml::View child : element) text += signature(child);
  return text + ">";
}

void set_pose(xml::View sensor, const Pose& X_CS, XmlEdits& edits) {
  const Vector3 rpy = to_rpy(X_CS.orientation);
  const std::string numbers = numbers_text(X_CS.position) + " " + numbers_text(rpy);
  if (const xml::View origin = sensor.child("origin")) {
    edits.replace(origin.span(), new_element("origin", origin_attributes(X_CS)));
  } else if (const xml::View pose = sensor.child("pose")) {
    edits.replace(pose.span(), "<pose>" + numbers + "</pose>");
  } else if (sensor.child("parent")) {  // of an old URDF
    edits.add_child(sensor, new_element("origin", origin_attributes(X_CS)));
  } else {
    edits.add_child(sensor, "<pose>" + numbers + "</pose>");
  }
}

}  // namespace

LinkReferences::LinkReferences(const LinkedModel& model) : model_(model) {
  const xml::View robot = model.robot->document.view();
  for (const xml::View element : passes::extension_elements(*model.robot)) {
    const std::string_view link = element.name() == "gazebo"
                                      ? attribute_of(element, "reference")
                                      : attribute_of(element.child("parent"), "link");
    const bool is_about_link = model.link_names.contains(link) && !model.joint_names.contains(link);
    if (element.parent().id() != robot.id()) {
      needed_.insert(attribute_of(element.parent(), "name"));
      read_names(element);
    } else if (element.name() == "gazebo" && is_about_link) {
      read_gazebo(element, link);
    } else if (element.name() == "sensor" && is_about_link) {
      sensors_[link].push_back(element);
      read_sensor(element);
    } else {
      read_names(element);
    }
  }
  for (auto& [link, properties] : properties_) std::sort(properties.begin(), properties.end());
  for (const urdf::Joint& joint : model.robot->joints) {
    if (joint.mimic && joint.mimic->joint) needed_.insert(*joint.mimic->joint);
    // Isaac keeps a joint with this attribute when it merges fixed joints.
    if (xml::View(model.robot->document, joint.element).attribute("dont_collapse") && joint.name) {
      needed_.insert(*joint.name);
    }
  }
}

void LinkReferences::read_gazebo(xml::View gazebo, std::string_view link) {
  gazebo_[link].push_back(gazebo);
  for (const xml::View child : gazebo) {
    const xml::View pose = child.child("pose");
    const bool is_simple_pose = !pose || pose.attributes().empty();
    // A contact sensor refers to a collision by the name that Gazebo derives from the link's name.
    const bool is_movable = child.name() == "sensor" && is_simple_pose && !child.child("contact");
    if (child.name() == "plugin" || (child.name() == "sensor" && !is_movable)) {
      needed_.insert(link);
    }
    if (child.name() == "sensor") {
      read_sensor(child);
    } else {
      if (child.name() != "plugin") properties_[link].push_back(signature(child));
      read_names(child);
    }
  }
}

/// The sensor's own name is not a reference, and its carrier is already known.
void LinkReferences::read_sensor(xml::View sensor) {
  for (const xml::View child : sensor) {
    if (child.name() != "parent") read_names(child);
  }
}

/// Calls a function for every text and attribute value that is the name of a link or joint.
void LinkReferences::read_names(xml::View element) {
  const auto add = [&](std::string_view text) {
    if (model_.link_names.contains(text) || model_.joint_names.contains(text)) needed_.insert(text);
  };
  for (const xml::Attribute& one : element.attributes()) {
    add(one.value());
  }
  add(trimmed(element.text()));
  for (const xml::View child : element) read_names(child);
}

const std::vector<std::string>& LinkReferences::properties(std::string_view link) const {
  static const std::vector<std::string> none;
  const auto found = properties_.find(link);
  return found == properties_.end() ? none : found->second;
}

bool LinkReferences::may_join(const urdf::Link& link, const urdf::Link& carrier) const {
  const std::vector<std::string>& own = properties(link.name.value_or(""));
  const bool is_mere_frame = own.empty() && link.visuals.empty() && link.collisions.empty();
  return is_mere_frame || own == properties(carrier.name.value_or(""));
}

void LinkReferences::move(const std::string& link, const std::string& carrier, const Pose& X_CL,
                          XmlEdits& edits) const {
  if (const auto found = gazebo_.find(link); found != gazebo_.end()) {
    for (const xml::View gazebo : found->second) {
      if (!gazebo.child("sensor")) {
        edits.remove(gazebo);
        continue;
      }
      edits.set_attribute(gazebo, "reference", carrier);
      for (const xml::View child : gazebo) {
        if (child.name() == "sensor") set_pose(child, X_CL * sensor_pose(child), edits);
      }
    }
  }
  if (const auto found = sensors_.find(link); found != sensors_.end()) {
    for (const xml::View sensor : found->second) {
      edits.set_attribute(sensor.child("parent"), "link", carrier);
      set_pose(sensor, X_CL * sensor_pose(sensor), edits);
    }
  }
}

}  // namespace smurf
