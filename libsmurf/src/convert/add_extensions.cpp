// SPDX-License-Identifier: BSD-3-Clause
// Writes motors as ros2_control or transmissions and sensors as Gazebo sensors: the inverse of
// import_motors.cpp and import_sensors.cpp. Things that the URDF already has are not repeated.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"
#include "convert/annotation_values.hpp"
#include "convert/passes.hpp"
#include "convert/sensor_views.hpp"
#include "link/gazebo_names.hpp"

namespace smurf::passes {
namespace {

std::string leaf(std::string_view name, std::string_view text) {
  return "<" + std::string(name) + ">" + escape_xml(text) + "</" + std::string(name) + ">";
}

std::string leaf(std::string_view name, double number) { return leaf(name, format_number(number)); }

std::string range_params(std::optional<double> low, std::optional<double> high) {
  const auto param = [](const char* name, double value) {
    return "\n      <param name=\"" + std::string(name) + "\">" + format_number(value) + "</param>";
  };
  return (low ? param("min", *low) : "") + (high ? param("max", *high) : "");
}

std::string ros2_joint(const urdf::Joint& joint, const Motor& motor) {
  std::string text = "  <joint name=\"" + escape_xml(*joint.name) + "\">\n";
  const std::string interface(interface_of(motor));
  // A joint that mimics is not commanded; ros2_control reads <mimic> itself.
  if (!motor.mimic_motor) {
    std::optional<double> low = limit_of(motor, LimitValue::lower);
    std::optional<double> high = limit_of(motor, LimitValue::upper);
    const auto bound =
        limit_of(motor, interface == "effort" ? LimitValue::effort : LimitValue::velocity);
    if (interface != "position") {
      high = bound;
      low = bound ? std::optional<double>(-*bound) : std::nullopt;
    }
    text += "    <command_interface name=\"" + interface + "\">" + range_params(low, high) +
            "\n    </command_interface>\n";
  }
  return text +
         "    <state_interface name=\"position\"/>\n    <state_interface name=\"velocity\"/>\n"
         "  </joint>\n";
}

std::string transmission(const urdf::Joint& joint, const Motor& motor) {
  std::string interface(interface_of(motor));
  interface.front() = static_cast<char>(interface.front() - 'a' + 'A');
  const std::string hardware =
      leaf("hardwareInterface", "hardware_interface/" + interface + "JointInterface");
  const std::string name = escape_xml(motor.name ? *motor.name : *joint.name);
  return "<transmission name=\"" + name + "_transmission\">\n" +
         "  <type>transmission_interface/SimpleTransmission</type>\n  <joint name=\"" +
         escape_xml(*joint.name) + "\">\n    " + hardware + "\n  </joint>\n  <actuator name=\"" +
         name + "_actuator\">\n    <mechanicalReduction>1</mechanicalReduction>\n  </actuator>\n" +
         "</transmission>";
}

/// Makes a sensor of Gazebo from the keys of an annotation.
class SensorContent {
 public:
  SensorContent(const Sensor& sensor, yaml::View entry)
      : sensor_(sensor), keys_(entry), view_(view_of(sensor, entry)) {}

  /// The lines inside <sensor>; "" when Gazebo has no such sensor.
  std::string content(std::string_view type) const {
    std::string text;
    if (sensor_.rate && *sensor_.rate > 0 && is_quantity(1000 / *sensor_.rate)) {
      text += "    " + leaf("update_rate", 1000 / *sensor_.rate) + "\n";
    }
    if (type == "CameraSensor") return text + camera();
    if (view_.scan) return text + rays(*view_.scan);
    if (type == "NodeContact") return text + contact();
    return text;
  }

 private:
  static std::string pose(const Vector3& position, const Vector3& rpy) {
    return "    " + leaf("pose", numbers_text(position) + " " + numbers_text(rpy)) + "\n";
  }

  std::string camera() const {
    const Vector3 rpy = keys_.rpy("orientation_offset");
    return pose(keys_.vector("position_offset"), rpy) + "    <camera>\n      " +
           leaf("horizontal_fov", keys_.camera_opening() * std::numbers::pi / 180) +
           "\n      <image>\n        " + leaf("width", keys_.camera_width()) + "\n        " +
           leaf("height", keys_.camera_height()) + "\n      </image>\n    </camera>\n";
  }

  std::string rays(const ScanView& scan) const {
    const bool is_flat = scan.up.count == 1 && scan.up.lowest == 0 && scan.up.highest == 0;
    return (view_.X_LS == Pose{} ? "" : pose({0, 0, 0}, keys_.rpy("rotation_offset"))) +
           "    <lidar>\n      <scan>\n" + fan("horizontal", scan.across) +
           (is_flat ? "" : fan("vertical", scan.up)) + "      </scan>\n      <range>\n        " +
           leaf("min", scan.nearest.value_or(0)) + "\n        " + leaf("max", *scan.farthest) +
           "\n      </range>\n    </lidar>\n";
  }

  static std::string fan(const char* name, const RayFan& fan) {
    return "        <" + std::string(name) + ">\n          " + leaf("samples", fan.count) +
           "\n          " + leaf("min_angle", fan.lowest) + "\n          " +
           leaf("max_angle", fan.highest) + "\n        </" + name + ">\n";
  }

  std::string contact() const {
    std::string text = "    <contact>\n";
    for (const Field<NameList>* list : {&sensor_.id, &sensor_.collisions}) {
      for (const Spanned<std::string>& name : list->value_or(NameList{})) {
        text += "      " + leaf("collision", name.value) + "\n";
      }
    }
    return text + "    </contact>\n";
  }

  const Sensor& sensor_;
  SensorKeys keys_;
  SensorView view_;
};

}  // namespace

std::string_view interface_of(const Motor& motor) {
  const std::string type = motor.type.value_or("PID");
  for (const char* name : {"DC", "generic_dc", "velocity", "2"}) {
    if (type == name) return "velocity";
  }
  for (const char* name : {"PID", "generic_bldc", "position", "1"}) {
    if (type == name) return "position";
  }
  return "effort";
}

std::set<std::string_view> names_in_extensions(const LinkedModel& model, std::string_view element,
                                               std::string_view extension) {
  std::set<std::string_view> names;
  const auto visit = [&](const auto& self, xml::View view) -> void {
    const xml::Attribute* name = view.attribute("name");
    if (view.name() == element && name != nullptr) names.insert(name->value());
    for (const xml::View child : view) self(self, child);
  };
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View top(model.robot->document, id);
    if (extension.empty() || top.name() == extension) visit(visit, top);
  }
  return names;
}

std::string_view gazebo_type(const Sensor& sensor) {
  constexpr std::pair<std::string_view, std::string_view> kTypes[] = {
      {"CameraSensor", "camera"}, {"RotatingRaySensor", "gpu_lidar"},
      {"RaySensor", "gpu_lidar"}, {"MultiLevelLaserRangeFinder", "gpu_lidar"},
      {"NodeRotation", "imu"},    {"NodeIMU", "imu"},
      {"NodeContact", "contact"}, {"Joint6DOF", "force_torque"}};
  for (const auto& [type, of_gazebo] : kTypes) {
    if (sensor.type && *sensor.type == type) return of_gazebo;
  }
  return {};
}

std::string gazebo_carrier(const LinkedModel& model, const Sensor& sensor) {
  if (gazebo_type(sensor) != "force_torque") {
    if (sensor.link) return *sensor.link;
    const bool is_imu = gazebo_type(sensor) == "imu";
    return is_imu && sensor.id && !sensor.id->empty() ? sensor.id->front().value : std::string();
  }
  if (sensor.joint) return *sensor.joint;
  // In Phobos, the named link means the joint that carries it.
  const auto link = sensor.link ? model.link_names.find(*sensor.link) : std::nullopt;
  if (!link || !model.tree.parent_joint[*link]) return {};
  return model.joint(*model.tree.parent_joint[*link]).name.value_or("");
}

bool gazebo_says(const Sensor& sensor, std::string_view key) {
  const std::string type = sensor.type.value_or("");
  if (is_one_of(key, {"name", "type", "link", "rate"})) return true;
  if (type == "CameraSensor") {
    return is_one_of(key, {"width", "height", "opening_width", "opening_angle", "position_offset",
                           "orientation_offset"});
  }
  if (type == "RotatingRaySensor") {
    return is_one_of(key, {"lasers", "opening_width", "opening_height", "horizontal_offset",
                           "vertical_offset", "horizontal_resolution", "min_distance",
                           "max_distance", "rotation_offset"});
  }
  if (type == "RaySensor") {
    return is_one_of(key, {"width", "opening_width", "max_distance"});
  }
  if (type == "MultiLevelLaserRangeFinder") {
    return is_one_of(key, {"numRaysHorizontal", "numRaysVertical", "horizontalOpeningAngle",
                           "verticalOpeningAngle", "maxDistance"});
  }
  if (type == "NodeContact") return is_one_of(key, {"id", "collisions"});
  return type == "Joint6DOF" ? is_one_of(key, {"joint"}) : is_one_of(key, {"id"});
}

std::set<std::string_view> driven_joints(const LinkedModel& model, Actuation actuation) {
  return names_in_extensions(model, "joint",
                             actuation == Actuation::ros2_control ? "ros2_control" : "");
}

std::vector<xml::View> replaced_transmissions(const LinkedModel& model, Actuation actuation) {
  std::vector<xml::View> replaced;
  if (actuation != Actuation::ros2_control) return replaced;
  std::set<std::string_view> driven = driven_joints(model, actuation);
  const AnnotationValues values(model);
  for (const Motor& motor : model.annotations.motors) {
    if (const urdf::Joint* joint = values.joint_of(motor)) driven.insert(*joint->name);
  }
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View element(model.robot->document, id);
    if (element.name() != "transmission") continue;
    const auto is_idle = [&](xml::View child) {
      const xml::Attribute* name = child.attribute("name");
      return child.name() == "joint" && (name == nullptr || !driven.contains(name->value()));
    };
    if (std::none_of(element.begin(), element.end(), is_idle)) replaced.push_back(element);
  }
  return replaced;
}

void add_actuation(const LinkedModel& model, Actuation actuation, XmlEdits& edits) {
  const AnnotationValues values(model);
  std::set<std::string_view> driven = driven_joints(model, actuation);
  std::string joints;
  for (const Motor& motor : model.annotations.motors) {
    const urdf::Joint* joint = values.joint_of(motor);
    if (joint == nullptr || !driven.insert(*joint->name).second) continue;
    if (actuation == Actuation::ros2_control) {
      joints += ros2_joint(*joint, motor);
    } else {
      edits.add_child(model.robot->document.view(), transmission(*joint, motor));
    }
  }
  if (joints.empty()) return;
  const std::string name = escape_xml(model.robot->name.value_or("robot"));
  edits.add_child(model.robot->document.view(),
                  "<ros2_control name=\"" + name + "\" type=\"system\">\n  <hardware>\n" +
                      "    <plugin>mock_components/GenericSystem</plugin>\n  </hardware>\n" +
                      joints + "</ros2_control>");
}

std::string gazebo_sensor(const yaml::Document& document, const Sensor& sensor,
                          std::string_view name) {
  const SensorContent content(sensor, yaml::View(document, sensor.node));
  return "  <sensor name=\"" + escape_xml(name) + "\" type=\"" + std::string(gazebo_type(sensor)) +
         "\">\n" + content.content(*sensor.type) + "  </sensor>\n";
}

namespace {

/// Gazebo gives collisions other names than the URDF.
std::string with_names_of_gazebo(std::string text, const LinkedModel& model,
                                 const GazeboNames& names) {
  constexpr std::string_view kBegin = "<collision>";
  for (std::size_t at = text.find(kBegin); at != std::string::npos; at = text.find(kBegin, at)) {
    at += kBegin.size();
    const std::size_t end = text.find("</", at);
    const std::string written = text.substr(at, end - at);
    for (std::size_t link = 0; link < names.collisions.size(); ++link) {
      const auto& collisions = model.robot->links[link].collisions;
      for (std::size_t i = 0; i < collisions.size(); ++i) {
        if (!collisions[i].name || escape_xml(*collisions[i].name) != written) continue;
        return text.substr(0, at) + escape_xml(names.collisions[link][i]) +
               with_names_of_gazebo(text.substr(end), model, names);
      }
    }
  }
  return text;
}

}  // namespace

void add_gazebo_sensors(const LinkedModel& model, XmlEdits& edits) {
  const GazeboNames names = gazebo_names(model);
  std::set<std::string_view> known = names_in_extensions(model, "sensor");
  for (const Sensor& sensor : model.annotations.sensors) {
    const std::string_view type = gazebo_type(sensor);
    const yaml::Document* document = model.document(sensor.span.source);
    if (type.empty() || document == nullptr || !sensor.name || !known.insert(*sensor.name).second) {
      continue;
    }
    const std::string carrier = gazebo_carrier(model, sensor);
    if (carrier.empty()) continue;
    edits.add_child(
        model.robot->document.view(),
        "<gazebo reference=\"" + escape_xml(carrier) + "\">\n" +
            with_names_of_gazebo(gazebo_sensor(*document, sensor, *sensor.name), model, names) +
            "</gazebo>");
  }
}

void add_mujoco_settings(const LinkedModel& model, bool has_new_paths, XmlEdits& edits) {
  const xml::View robot = model.robot->document.view();
  const xml::View settings = robot.child("mujoco");
  const std::string compiler = new_element("compiler", {{"strippath", "false"}});
  if (!settings) {
    edits.add_child(robot, "<mujoco>\n  " + compiler + "\n</mujoco>");
  } else if (const xml::View known = settings.child("compiler")) {
    // A setting of the author is kept, unless it concerns paths that were rewritten.
    if (has_new_paths || known.attribute("strippath") == nullptr) {
      edits.set_attribute(known, "strippath", "false");
    }
    for (const char* folder : {"meshdir", "texturedir", "assetdir"}) {
      const xml::Attribute* attribute = known.attribute(folder);
      if (has_new_paths && attribute != nullptr) edits.remove(*attribute);
    }
  } else {
    edits.add_child(settings, compiler);
  }
}

}  // namespace smurf::passes
