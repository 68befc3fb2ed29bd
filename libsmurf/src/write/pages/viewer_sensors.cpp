// SPDX-License-Identifier: BSD-3-Clause
#include "write/pages/viewer_sensors.hpp"

#include "base/text/words.hpp"
#include "convert/gazebo_sensors.hpp"
#include "convert/import.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf {
namespace {

class Collector {
 public:
  explicit Collector(const LinkedModel& model) : model_(model) {}

  std::vector<ViewerSensor> collect() {
    for (const GazeboSensor& found : gazebo_sensors(*model_.robot)) of_gazebo(found);
    for (const Sensor& sensor : model_.annotations.sensors) of_annotation(sensor);
    return std::move(sensors_);
  }

 private:
  std::optional<std::size_t> link_or_child(std::string_view name) const {
    if (const auto link = model_.link_names.find(name)) return *link;
    return child_of(name);
  }

  std::optional<std::size_t> child_of(std::string_view name) const {
    const auto joint = model_.joint_names.find(name);
    return joint ? carried_link(model_, *joint) : std::nullopt;
  }

  void of_gazebo(const GazeboSensor& found) {
    const xml::View element = found.element;
    const std::optional<std::size_t> link = link_or_child(found.reference);
    if (!link) return;
    sensors_.push_back({std::string(attribute_of(element, "name")),
                        std::string(attribute_of(element, "type")) + " in <gazebo>", *link,
                        view_of(element), nullptr, element.id()});
  }

  void of_annotation(const Sensor& sensor) {
    const yaml::Document* document = model_.document(sensor.span.source);
    if (document == nullptr) return;
    const SensorView view = view_of(sensor, yaml::View(*document, sensor.node));
    for (const std::size_t link : links_of(sensor)) {
      sensors_.push_back({sensor.name.value_or({}), sensor.type.value_or({}), link, view, &sensor,
                          xml::kNoElement});
    }
  }

  std::set<std::size_t> links_of(const Sensor& sensor) const {
    if (sensor.link) {
      const auto link = model_.link_names.find(*sensor.link);
      return link ? std::set<std::size_t>{*link} : std::set<std::size_t>();
    }
    if (sensor.joint) {
      const auto link = child_of(*sensor.joint);
      return link ? std::set<std::size_t>{*link} : std::set<std::size_t>();
    }
    std::set<std::size_t> links;
    const bool measures_links = sensor.type && sensor.type->starts_with("Node");
    for (const Field<NameList>* list : {&sensor.links, &sensor.id}) {
      for (const Spanned<std::string>& name : list->value_or(NameList{})) {
        if (list == &sensor.id && !measures_links) continue;
        if (const auto link = model_.link_names.find(name.value)) links.insert(*link);
      }
    }
    return links;
  }

  const LinkedModel& model_;
  std::vector<ViewerSensor> sensors_;
};

void print_number(JsonPrinter& json, std::string_view key, const std::optional<double>& value) {
  if (!value) return;
  json.key(key);
  json.number(*value);
}

void print_view(const SensorView& view, JsonPrinter& json) {
  const Vector3& p = view.X_LS.position;
  const Quaternion& q = view.X_LS.orientation;
  if (view.X_LS != Pose{}) json.member("pose", {p[0], p[1], p[2], q.w, q.x, q.y, q.z});
  if (!view.why_unseen.empty()) json.member("why", view.why_unseen);
  if (const auto& camera = view.camera) {
    json.member("camera", {camera->width, camera->height});
    print_number(json, "nearest", camera->nearest);
    print_number(json, "farthest", camera->farthest);
  }
  if (const auto& scan = view.scan) {
    json.member("across", {scan->across.lowest, scan->across.highest, scan->across.count});
    json.member("up", {scan->up.lowest, scan->up.highest, scan->up.count});
    print_number(json, "nearest", scan->nearest);
    print_number(json, "farthest", scan->farthest);
  }
}

std::set<const Sensor*> annotations_of(const std::vector<ViewerSensor>& sensors) {
  std::set<const Sensor*> annotations;
  for (const ViewerSensor& sensor : sensors) annotations.insert(sensor.annotation);
  annotations.erase(nullptr);
  return annotations;
}

/// The link that a joint moves.
std::optional<std::uint32_t> child_of(const LinkedModel& model, const Field<std::string>& joint) {
  const auto index = joint ? model.joint_names.find(*joint) : std::nullopt;
  const auto child = index ? model.tree.joint_child[*index] : std::nullopt;
  return child ? std::optional(static_cast<std::uint32_t>(to_size(*child))) : std::nullopt;
}

void print_device(std::string_view kind, const Field<std::string>& name,
                  const std::optional<std::uint32_t>& link, JsonPrinter& json) {
  if (!name || !link) return;
  json.begin_object();
  json.member("kind", kind);
  json.member("name", *name);
  json.key("link");
  json.integer(*link);
  json.end();
}

}  // namespace

std::vector<ViewerSensor> viewer_sensors(const LinkedModel& model) {
  return model.robot ? Collector(model).collect() : std::vector<ViewerSensor>();
}

std::set<const Sensor*> sensors_on_page(const LinkedModel& model) {
  return annotations_of(viewer_sensors(model));
}

std::vector<xml::View> unshown_settings(xml::View sensor) {
  std::vector<xml::View> unshown;
  for (const xml::View child : sensor) {
    if (is_one_of(child.name(), {"pose", "origin", "parent"})) continue;
    const bool is_camera = child.name() == "camera";
    if (!is_camera && child.name() != "ray" && child.name() != "lidar") {
      unshown.push_back(child);
      continue;
    }
    for (const xml::View setting : child) {
      const bool is_setting_shown =
          is_camera ? is_one_of(setting.name(), {"horizontal_fov", "image", "clip"})
                    : is_one_of(setting.name(), {"scan", "range"});
      if (!is_setting_shown) unshown.push_back(setting);
    }
  }
  return unshown;
}

bool is_shown(const Sensor& sensor, std::string_view key) {
  if (is_one_of(key, {"name", "type", "link", "joint", "id", "links"})) return true;
  const std::string type = sensor.type.value_or("");
  if (type == "CameraSensor") {
    return is_one_of(key, {"width", "height", "opening_width", "opening_height", "opening_angle",
                           "opening_angle2", "range", "position_offset", "orientation_offset"});
  }
  if (type == "RaySensor") return is_one_of(key, {"width", "opening_width", "max_distance"});
  if (type == "RotatingRaySensor") {
    return is_one_of(key, {"lasers", "opening_width", "opening_height", "horizontal_offset",
                           "vertical_offset", "horizontal_resolution", "min_distance",
                           "max_distance", "rotation_offset"});
  }
  return type == "MultiLevelLaserRangeFinder" &&
         is_one_of(key, {"numRaysHorizontal", "numRaysVertical", "horizontalOpeningAngle",
                         "verticalOpeningAngle", "maxDistance"});
}

void print_devices(const LinkedModel& model, JsonPrinter& json) {
  json.key("devices");
  json.begin_list(JsonPrinter::Layout::block);
  for (const Motor& motor : model.annotations.motors) {
    print_device("motor", motor.name, child_of(model, motor.joint), json);
  }
  for (const Sensor& sensor : model.annotations.sensors) {
    const auto link = sensor.link ? model.link_names.find(*sensor.link) : std::nullopt;
    print_device("sensor", sensor.name, link ? link : child_of(model, sensor.joint), json);
  }
  json.end();
}

void print_sensors(const LinkedModel& model, JsonPrinter& json) {
  json.key("sensors");
  json.begin_list(JsonPrinter::Layout::block);
  const std::vector<ViewerSensor> sensors = viewer_sensors(model);
  for (const ViewerSensor& sensor : sensors) {
    json.begin_object();
    json.member("name", sensor.name);
    json.member("type", sensor.type);
    json.key("link");
    json.integer(static_cast<std::int64_t>(sensor.link));
    print_view(sensor.view, json);
    json.end();
  }
  const std::set<const Sensor*> shown = annotations_of(sensors);
  for (const Sensor& sensor : model.annotations.sensors) {
    if (shown.contains(&sensor)) continue;
    json.begin_object();
    json.member("name", sensor.name.value_or({}));
    json.member("type", sensor.type.value_or({}));
    json.member("why", "it is on no link");
    json.end();
  }
  json.end();
}

}  // namespace smurf
