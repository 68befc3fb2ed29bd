// SPDX-License-Identifier: BSD-3-Clause
#include "write/sdf_model.hpp"

#include "base/edits.hpp"
#include "convert/passes.hpp"
#include "write/placed_shapes.hpp"
#include "write/sdf_names.hpp"

namespace smurf {

RepeatedParts sdf_parts(const LinkedModel& model) {
  RepeatedParts parts;
  for (const Sensor& sensor : model.annotations.sensors) {
    const yaml::Document* document = model.document(sensor.span.source);
    if (document == nullptr || !sensor.name || passes::gazebo_type(sensor).empty()) continue;
    parts.bytes += passes::gazebo_sensor(*document, sensor, *sensor.name).size();
  }
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

SdfModel::SdfModel(const LinkedModel& model, const SourceMap& sources)
    : model_(model), contacts(model), gazebo(model, sources.text(model.robot->document.source)) {
  const std::set<std::string_view> known = passes::names_in_extensions(model, "sensor");
  for (const Sensor& sensor : model.annotations.sensors) {
    if (passes::gazebo_type(sensor).empty() || !sensor.name || known.contains(*sensor.name)) {
      continue;
    }
    sensors_.emplace(passes::gazebo_carrier(model, sensor), &sensor);
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

}  // namespace smurf
