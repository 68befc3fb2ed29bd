// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf/mjcf_sensors.hpp"

#include "base/numbers/numbers.hpp"

namespace smurf {

RepeatedParts mjcf_repeated_parts(const LinkedModel& model) {
  constexpr std::uint64_t kElement = 400;  // bytes, as check_scene_size() counts shapes
  RepeatedParts parts;
  for (const MujocoSensor& sensor : mujoco_sensors(model, {})) {
    parts.bytes += kElement + sensor.name.size();
    parts.names += 1;
    for (const MujocoReading& reading : sensor.readings) {
      parts.bytes += kElement + sensor.name.size() + reading.part.size() +
                     (reading.name.empty() ? sensor.name : reading.name).size();
      parts.names += 2;
    }
  }
  for (const JointDrive& drive : joint_drives(model, {}, FollowerDrives::as_written)) {
    parts.bytes += kElement + drive.name.size();
    parts.names += 2;
  }
  parts.names += model.robot->links.size();
  for (const urdf::Link& link : model.robot->links) {
    parts.names += link.visuals.size() + link.collisions.size();
  }
  for (const urdf::Joint& joint : model.robot->joints) parts.names += joint.mimic ? 3 : 1;
  return parts;
}

const MjcfSensors::OfModel& MjcfSensors::sensors_of(const LinkedModel& model) {
  const auto [known, is_new] = of_model_.try_emplace(&model);
  OfModel& found = known->second;
  if (!is_new) return found;
  found.sensors = mujoco_sensors(model, scene_.motors);
  for (std::size_t i = 0; i < found.sensors.size(); ++i) {
    if (found.sensors[i].link) found.by_link.emplace(*found.sensors[i].link, i);
  }
  return found;
}

void MjcfSensors::add_mounts(std::size_t i, std::size_t link) {
  if (xml_.is_full()) return;
  const OfModel& found = sensors_of(*robot_of(i));
  const auto [first, last] = found.by_link.equal_range(link);
  for (auto at = first; at != last; ++at) {
    const MujocoSensor& sensor = found.sensors[at->second];
    std::vector<XmlText::Attribute> attributes{{"name", name(i, sensor.name)},
                                               {"pos", join_numbers(sensor.X_LS.position)},
                                               {"quat", quaternion_text(sensor.X_LS.orientation)}};
    if (sensor.reach) {
      attributes.emplace_back("type", "box");
      attributes.emplace_back("size", join_numbers(*sensor.reach));
      attributes.emplace_back("group", "4");  // a group that viewers hide at first
    }
    if (sensor.fovy) attributes.emplace_back("fovy", format_number(*sensor.fovy));
    xml_.empty(sensor.fovy ? "camera" : "site", attributes);
  }
}

void MjcfSensors::add_sensors() {
  for (std::size_t i = 0; i < count(); ++i) {
    const LinkedModel* model = robot_of(i);
    if (model == nullptr || !flat(i).X_WE) continue;
    for (const MujocoSensor& sensor : sensors_of(*model).sensors) {
      if (xml_.is_full()) break;
      for (const MujocoReading& reading : sensor.readings) add_reading(i, sensor, reading);
    }
  }
  if (is_open_) xml_.close();
}

void MjcfSensors::add_reading(std::size_t i, const MujocoSensor& sensor,
                              const MujocoReading& reading) {
  if (!is_open_) xml_.open("sensor");
  is_open_ = true;
  std::vector<XmlText::Attribute> attributes;
  attributes.emplace_back("name", sensor_names_.add(name(i, sensor.name + reading.part)));
  if (reading.object == "objname") {
    // In MuJoCo, "body" means the frame of the inertia; "xbody" is that of the link.
    attributes.emplace_back("objtype", reading.name.empty() ? "site" : "xbody");
  }
  attributes.emplace_back(reading.object,
                          name(i, reading.name.empty() ? sensor.name : reading.name));
  if (!reading.reference.empty()) {
    attributes.emplace_back("reftype", "site");
    attributes.emplace_back("refname", name(i, reading.reference));
  }
  if (reading.cutoff > 0) attributes.emplace_back("cutoff", format_number(reading.cutoff));
  xml_.empty(reading.element, attributes);
}

}  // namespace smurf
