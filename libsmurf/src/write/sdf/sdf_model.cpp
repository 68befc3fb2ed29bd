// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf/sdf_model.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "base/text/edits.hpp"
#include "convert/import.hpp"
#include "convert/passes.hpp"
#include "link/gazebo_names.hpp"
#include "write/parts/placed_shapes.hpp"
#include "write/sdf/sdf_names.hpp"

namespace smurf {

RepeatedParts sdf_parts(const LinkedModel& model) {
  RepeatedParts parts;
  for (const Sensor& sensor : model.annotations.sensors) {
    const yaml::Document* document = model.document(sensor.span.source);
    if (document == nullptr || !sensor.name || passes::gazebo_type(sensor).empty()) continue;
    parts.bytes += passes::gazebo_sensor(*document, sensor, *sensor.name).size();
  }
  constexpr std::uint64_t kController = 300;  // bytes
  for (const Motor& motor : model.annotations.motors)
    parts.bytes += kController + (motor.joint ? motor.joint->size() : 0);
  for (const urdf::Link& link : model.robot->links) {
    const std::size_t name = link.name ? link.name->size() : 0;
    for (const urdf::Visual& visual : link.visuals) {
      const std::string* texture = written_texture(visual, model);
      parts.bytes += (visual.name ? 0 : name) + (texture != nullptr ? texture->size() : 0);
    }
    for (const urdf::Collision& shape : link.collisions) parts.bytes += shape.name ? 0 : name;
  }
  return parts;
}

SdfModel::SdfModel(const LinkedModel& model, const SceneExport& scene)
    : model_(model),
      tree(sdf_tree(model, kept_parts(model, scene))),
      shape_names(sdf_shape_names(model, tree.bodies)),
      contacts(model),
      gazebo(model, scene.sources.text(model.robot->document.source)) {
  if (scene.contacts.choice != SelfCollision::as_usual) gazebo.leave_out_own_contacts();
  name_contacts();
  const std::set<std::string_view> known = passes::names_in_extensions(model, "sensor");
  for (const Sensor& sensor : model.annotations.sensors) {
    if (passes::gazebo_type(sensor).empty() || !sensor.name || known.contains(*sensor.name)) {
      continue;
    }
    sensors_.emplace(passes::gazebo_carrier(model, sensor), &sensor);
  }
}

/// libsdformat merges links and names their collisions accordingly; here, the links are kept. A
/// contact sensor belongs to the link of its collision.
void SdfModel::name_contacts() {
  const std::vector<ContactName> names = contact_names(model_);
  if (names.empty()) return;
  const GazeboNames known = gazebo_names(model_);
  std::map<xml::ElementId, std::size_t> body_of_sensor;
  for (const ContactName& name : names) {
    const auto place = find_collision(known, name.link, name.text);
    if (!place) continue;  // Gazebo does not find it either
    const xml::ElementId sensor = name.element.parent().parent().id();
    const std::size_t body = tree.bodies[place->link];
    const auto [first, is_new] = body_of_sensor.emplace(sensor, body);
    if (first->second != body) {
      lost_contacts_.emplace_back(name.element.name_span(), name.text);
      continue;
    }
    const urdf::Link& link = model_.robot->links[place->link];
    const auto written = shape_names.collisions.find(&link.collisions[place->collision]);
    if (written == shape_names.collisions.end()) continue;
    gazebo.set_text(name.element, written->second);
    if (is_new && tree.bodies[name.link] != body && model_.robot->links[body].name) {
      gazebo.move(sensor, *model_.robot->links[name.link].name, *model_.robot->links[body].name);
    }
  }
}

void SdfModel::add_to_link(XmlText& xml, std::size_t part, std::string_view frame, const Pose& X_BL,
                           bool is_old, UniqueNames& names) const {
  const Field<std::string>& name = model_.robot->links[part].name;
  if (!name) return;
  if (!gazebo.empty()) gazebo.add_to_link(xml, *name, frame, X_BL, names);
  if (!is_old) add_sensors(xml, *name, frame, names);
}

void SdfModel::add_to_joint(XmlText& xml, const urdf::Joint& joint, bool is_old,
                            UniqueNames& names) const {
  if (!joint.name) return;
  if (!gazebo.empty()) gazebo.add_to_joint(xml, *joint.name, names);
  if (!is_old && !model_.link_names.contains(*joint.name)) {
    add_sensors(xml, *joint.name, {}, names);
  }
}

void SdfModel::add_sensors(XmlText& xml, std::string_view carrier, std::string_view frame,
                           UniqueNames& names) const {
  const auto [first, last] = sensors_.equal_range(carrier);
  for (auto at = first; at != last; ++at) {
    if (xml.is_full()) return;
    const Sensor& sensor = *at->second;
    const yaml::Document* document = model_.document(sensor.span.source);
    if (document == nullptr) continue;
    std::string text = passes::gazebo_sensor(*document, sensor, names.add(sdf_name(*sensor.name)));
    constexpr std::string_view kEnd = "</collision>";
    for (std::size_t end = text.find(kEnd); end != std::string::npos; end = text.find(kEnd, end)) {
      text.insert(end, "_collision");  // names of collisions in the result
      end += kEnd.size() + std::string_view("_collision").size();
    }
    if (!frame.empty()) {
      const std::string relative = "<pose relative_to=\"" + escape_xml(frame) + "\">";
      const std::size_t pose = text.find("<pose>");
      if (pose != std::string::npos) {
        text.replace(pose, std::string_view("<pose>").size(), relative);
      } else {
        text.insert(text.find('\n') + 1, "    " + relative + "0 0 0 0 0 0</pose>\n");
      }
    }
    xml.raw(text);
  }
}

namespace {

struct System {
  std::string_view file, name;
  std::initializer_list<std::string_view> sensors;  ///< types; "": in every world with systems
};

/// Those that Gazebo loads by default into a world without plug-ins come first.
const std::array<System, 12> kSystems{{
    {"physics", "Physics", {""}},
    {"user-commands", "UserCommands", {""}},
    {"scene-broadcaster", "SceneBroadcaster", {""}},
    {"sensors",
     "Sensors",
     {"camera", "depth_camera", "depth", "multicamera", "rgbd_camera", "rgbd", "gpu_lidar",
      "gpu_ray", "lidar", "ray", "thermal_camera", "thermal", "wideanglecamera",
      "segmentation_camera", "segmentation", "boundingbox_camera", "boundingbox"}},
    {"imu", "Imu", {"imu"}},
    {"contact", "Contact", {"contact"}},
    {"forcetorque", "ForceTorque", {"force_torque"}},
    {"navsat", "NavSat", {"navsat", "gps"}},
    {"altimeter", "Altimeter", {"altimeter"}},
    {"magnetometer", "Magnetometer", {"magnetometer"}},
    {"air-pressure", "AirPressure", {"air_pressure"}},
    {"logical-camera", "LogicalCamera", {"logical_camera"}},
}};

std::set<std::string> sensor_types(const LinkedModel& model) {
  std::set<std::string> types;
  if (!model.robot) return types;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    for (const xml::View child : gazebo) {
      if (child.name() != "sensor" || !is_taken_by_gazebo(model, child)) continue;
      types.emplace(attribute_of(child, "type"));
    }
  }
  for (const Sensor& sensor : model.annotations.sensors) {
    const bool is_written = sensor.name && !passes::gazebo_carrier(model, sensor).empty();
    if (is_written) types.emplace(passes::gazebo_type(sensor));
  }
  return types;
}

bool runs_one_of(const System& system, const std::set<std::string>& types) {
  return std::any_of(system.sensors.begin(), system.sensors.end(), [&](std::string_view type) {
    return !type.empty() && types.contains(std::string(type));
  });
}

}  // namespace

bool needs_sdf_systems(const LinkedModel& model) {
  const std::set<std::string> types = sensor_types(model);
  return std::any_of(kSystems.begin(), kSystems.end(),
                     [&](const System& system) { return runs_one_of(system, types); });
}

void add_sdf_systems(XmlText& xml, const LinkedScene& scene) {
  std::set<std::string> types;
  for (const LinkedModel& model : scene.models) types.merge(sensor_types(model));
  const bool has_any = std::any_of(kSystems.begin(), kSystems.end(), [&](const System& system) {
    return runs_one_of(system, types);
  });
  if (!has_any) return;
  for (const System& system : kSystems) {
    if (*system.sensors.begin() != "" && !runs_one_of(system, types)) continue;
    const XmlText::Attributes attributes{
        {"filename", "gz-sim-" + std::string(system.file) + "-system"},
        {"name", "gz::sim::systems::" + std::string(system.name)}};
    if (system.name != "Sensors") {
      xml.empty("plugin", attributes);
      continue;
    }
    xml.open("plugin", attributes);
    xml.leaf("render_engine", "ogre2");
    xml.close();
  }
}

}  // namespace smurf
