// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf/mujoco_sensors.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "base/numbers/numbers.hpp"
#include "base/text/unique_names.hpp"
#include "base/text/words.hpp"
#include "convert/gazebo_sensors.hpp"
#include "convert/import.hpp"
#include "convert/passes.hpp"
#include "convert/sensor_views.hpp"
#include "write/parts/joint_drives.hpp"
#include "write/parts/ray_directions.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/parts/touched_boxes.hpp"

namespace smurf {
namespace {

constexpr double kRadians = std::numbers::pi / 180;
/// The length of a written reading without its names.
constexpr std::size_t kReadingBytes = 100;
/// Cameras of Gazebo and MARS look along x, with z up (MARS CameraSensor.cpp, preGraphicsUpdate());
/// those of MuJoCo along -z, with y up.
const Quaternion kCameraAxes{0.5, 0.5, -0.5, -0.5};
/// Single rays of Gazebo and MARS go along x (MARS RaySensor.cpp), those of MuJoCo along z.
const Quaternion kRayAxes{std::numbers::sqrt2 / 2, 0, std::numbers::sqrt2 / 2, 0};

Pose with_axes(const Pose& pose, const Quaternion& axes) { return pose * Pose{{}, axes}; }

double number_in(xml::View element, std::string_view child, double fallback) {
  return element ? parse_number(import::child_text(element, child)).value_or(fallback) : fallback;
}

class SensorReader {
 public:
  SensorReader(const LinkedModel& model, const MotorOptions& options)
      : model_(model), X_RL_(forward_kinematics(model, {})), boxes_(model) {
    for (const JointDrive& drive : joint_drives(model, options, FollowerDrives::as_written))
      motors_.emplace(drive.joint, drive.name);
  }

  std::vector<MujocoSensor> read() {
    for (const GazeboSensor& found : gazebo_sensors(*model_.robot)) of_gazebo(found);
    for (const Sensor& sensor : model_.annotations.sensors) of_annotation(sensor);
    return std::move(sensors_);
  }

 private:
  std::optional<std::size_t> link(std::string_view name) const {
    const auto found = model_.link_names.find(name);
    return found && X_RL_[*found] ? std::optional<std::size_t>(*found) : std::nullopt;
  }

  std::optional<std::size_t> link_of_joint(std::string_view name) const {
    const auto joint = model_.joint_names.find(name);
    const auto carried = joint ? carried_link(model_, *joint) : std::nullopt;
    return carried && X_RL_[*carried] ? carried : std::nullopt;
  }

  /// Subtracts the bytes of the readings from kMostReadingBytes; false if too few remain. Each
  /// reading has the name `name`, and all together have `more` bytes of other names. A single
  /// reading is free, because its annotation is as long.
  bool can_afford(std::size_t readings, std::string_view name, std::size_t more = 0) {
    const std::size_t bytes = readings * (kReadingBytes + name.size()) + more;
    if (readings <= 1) return true;
    if (bytes > bytes_left_) return false;
    bytes_left_ -= bytes;
    return true;
  }

  bool add(std::string_view name, std::optional<std::size_t> link, const Pose& X_LS,
           std::vector<MujocoReading> readings) {
    if (!link) return false;
    sensors_.push_back({names_.add(std::string(name)), link, X_LS, {}, {}, std::move(readings)});
    return true;
  }

  bool add_imu(std::string_view name, std::optional<std::size_t> link, const Pose& X_LS) {
    return add(name, link, X_LS,
               {{"accelerometer", "site", {}, "/acceleration"},
                {"gyro", "site", {}, "/angular_velocity"},
                {"framequat", "objname", {}, "/orientation"}});
  }

  bool add_wrench(std::string_view name, std::optional<std::size_t> link, const Pose& X_LS) {
    return add(name, link, X_LS,
               {{"force", "site", {}, "/force"}, {"torque", "site", {}, "/torque"}});
  }

  bool add_camera(std::string_view name, std::optional<std::size_t> link, const Pose& X_LS,
                  std::optional<double> fovy) {
    if (!fovy || !add(name, link, with_axes(X_LS, kCameraAxes), {})) return false;
    sensors_.back().fovy = fovy;
    return true;
  }

  /// MuJoCo has only single rays, so each ray of a scan becomes a sensor.
  bool add_rays(std::string_view name, std::optional<std::size_t> link, const SensorView& view) {
    if (!view.scan || !link || !can_afford(ray_count(*view.scan), name)) return false;
    const std::vector<Quaternion> rays = ray_directions(*view.scan);
    const double range = view.scan->farthest.value_or(0);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const std::string part = rays.size() > 1 ? "/" + std::to_string(i) : std::string();
      add(std::string(name) + part, link, with_axes(with_axes(view.X_LS, rays[i]), kRayAxes),
          {{"rangefinder", "site", {}, {}, std::isfinite(range) ? range : 0}});
    }
    return !rays.empty();
  }

  bool add_touch(std::string_view name, const TouchedBoxes& boxes) {
    std::size_t names = 0;
    for (const auto& [link, box] : boxes) {
      const Field<std::string>& of_link = model_.robot->links[link].name;
      names += of_link ? of_link->size() : 0;
    }
    if (!can_afford(boxes.size(), name, names)) return false;
    for (const auto& [link, box] : boxes) {
      if (!X_RL_[link]) return false;
    }
    for (const auto& [link, box] : boxes) {
      std::string whole(name);
      if (boxes.size() > 1) whole += "/" + model_.robot->links[link].name.value_or("");
      add(whole, link, {box.center(), {}}, {{"touch", "site", {}}});
      const Vector3 size = box.size();
      sensors_.back().reach = Vector3{size[0] / 2, size[1] / 2, size[2] / 2};
    }
    return !boxes.empty();
  }

  void of_gazebo(const GazeboSensor& found) {
    const xml::View sensor = found.element;
    const std::string_view name = attribute_of(sensor, "name");
    const std::size_t first = sensors_.size();
    if (name.empty() || !is_gazebo_taken(sensor, found.reference, name)) return;
    for (std::size_t i = first; i < sensors_.size(); ++i) sensors_[i].element = sensor.id();
    known_.insert(name);
  }

  bool is_gazebo_taken(xml::View sensor, std::string_view reference, std::string_view name) {
    const std::string_view type = attribute_of(sensor, "type");
    const Pose X_LS = sensor_pose(sensor);
    if (type == "imu") return add_imu(name, link(reference), X_LS);
    if (type == "force_torque") return is_wrench_taken(sensor, reference, name, X_LS);
    if (type == "camera" || type == "depth" || type == "depth_camera" || type == "rgbd_camera") {
      const xml::View camera = sensor.child("camera");
      const xml::View image = camera ? camera.child("image") : xml::View();
      const double fov = number_in(camera, "horizontal_fov", 1.047);
      return add_camera(name, link(reference), X_LS,
                        vertical_opening(fov / kRadians, number_in(image, "width", 320),
                                         number_in(image, "height", 240)));
    }
    if (type == "ray" || type == "gpu_ray" || type == "lidar" || type == "gpu_lidar") {
      return add_rays(name, link(reference), view_of(sensor));
    }
    return (type == "contact" || type == "bumper") && is_contact_taken(sensor, reference, name);
  }

  /// MuJoCo only measures the force of a child on its parent.
  bool is_wrench_taken(xml::View sensor, std::string_view joint, std::string_view name,
                       const Pose& X_LS) {
    const xml::View settings = sensor.child("force_torque");
    const auto text = [&](std::string_view key) {
      return settings ? import::child_text(settings, key) : std::string_view();
    };
    const bool is_usual =
        text("measure_direction").empty() || text("measure_direction") == "child_to_parent";
    if (!is_usual || text("frame") == "parent") return false;
    return add_wrench(name, link_of_joint(joint), text("frame") == "sensor" ? X_LS : Pose{});
  }

  bool is_contact_taken(xml::View sensor, std::string_view reference, std::string_view name) {
    const auto carrier = link(reference);
    const xml::View contact = sensor.child("contact");
    const std::string_view collision =
        contact ? import::child_text(contact, "collision") : std::string_view();
    return carrier && add_touch(name, boxes_.of(*carrier, collision));
  }

  void of_annotation(const Sensor& sensor) {
    if (!sensor.name || !sensor.type || known_.contains(*sensor.name)) return;
    const std::size_t first = sensors_.size();
    if (!is_annotation_taken(sensor)) return;
    for (std::size_t i = first; i < sensors_.size(); ++i) sensors_[i].annotation = &sensor;
  }

  bool is_annotation_taken(const Sensor& sensor) {
    const std::string& type = *sensor.type;
    if (type == "NodeIMU") {
      return add_imu(*sensor.name, link(passes::gazebo_carrier(model_, sensor)), {});
    }
    if (type == "Joint6DOF") {
      return add_wrench(*sensor.name, link_of_joint(passes::gazebo_carrier(model_, sensor)), {});
    }
    if (type == "CameraSensor" || type == "RaySensor" || type == "RotatingRaySensor" ||
        type == "MultiLevelLaserRangeFinder") {
      return is_view_taken(sensor);
    }
    if (type == "NodeContact" || type == "NodeContactForce") {
      const std::size_t most = bytes_left_ / (kReadingBytes + sensor.name->size());
      return add_touch(*sensor.name, boxes_.of(targets({&sensor.id, &sensor.collisions}), most));
    }
    constexpr std::pair<std::string_view, std::string_view> kOfJoints[] = {
        {"JointPosition", "jointpos"}, {"JointVelocity", "jointvel"}};
    for (const auto& [name, element] : kOfJoints) {
      if (type == name) return is_joint_taken(sensor, element);
    }
    if (type == "JointTorque") return is_joint_taken(sensor, "actuatorfrc");
    constexpr std::pair<std::string_view, std::string_view> kOfLinks[] = {
        {"NodePosition", "framepos"},
        {"NodeRotation", "framequat"},
        {"NodeVelocity", "framelinvel"},
        {"NodeAngularVelocity", "frameangvel"}};
    for (const auto& [name, element] : kOfLinks) {
      if (type == name) return is_frame_taken(sensor, element);
    }
    return false;
  }

  bool is_view_taken(const Sensor& sensor) {
    const yaml::Document* document = model_.document(sensor.span.source);
    if (document == nullptr || !sensor.link) return false;
    const yaml::View entry(*document, sensor.node);
    if (*sensor.type != "CameraSensor") {
      return add_rays(*sensor.name, link(*sensor.link), view_of(sensor, entry));
    }
    const SensorKeys keys(entry);
    return add_camera(*sensor.name, link(*sensor.link), keys.camera_pose(), vertical_opening(keys));
  }

  static std::vector<std::string> targets(std::initializer_list<const Field<NameList>*> lists) {
    std::vector<std::string> names;
    for (const Field<NameList>* list : lists) {
      for (const Spanned<std::string>& name : list->value_or(NameList{})) {
        names.push_back(name.value);
      }
    }
    return names;
  }

  /// False if nothing is measured.
  bool add_readings(const Sensor& sensor, std::vector<MujocoReading> readings) {
    if (readings.empty() || !can_afford(readings.size(), *sensor.name)) return false;
    sensors_.push_back({names_.add(*sensor.name), {}, {}, {}, {}, std::move(readings)});
    return true;
  }

  bool is_joint_taken(const Sensor& sensor, std::string_view element) {
    std::vector<MujocoReading> readings;
    for (const std::string& name : targets({&sensor.id, &sensor.joints})) {
      const urdf::Joint* joint = model_.find_joint(name);
      if (joint == nullptr || !joint->has_one_axis() || !link_of_joint(name)) return false;
      if (element != "actuatorfrc") {
        readings.push_back({element, "joint", name, "/" + name});
      } else if (const auto motor = motors_.find(joint); motor != motors_.end()) {
        readings.push_back({element, "actuator", motor->second, "/" + name});
      } else {
        return false;
      }
    }
    return add_readings(sensor, std::move(readings));
  }

  /// A frame beside that of a link is that of a site, and so is that in which it is measured.
  bool is_frame_taken(const Sensor& sensor, std::string_view element) {
    const yaml::Document* document = model_.document(sensor.span.source);
    const std::vector<std::string> names = targets({&sensor.id, &sensor.links});
    const auto is_gone = [&](const std::string& name) { return !link(name); };
    if (document == nullptr || std::any_of(names.begin(), names.end(), is_gone)) return false;
    const yaml::View entry(*document, sensor.node);
    const SensorKeys keys(entry);
    const Pose X_LF{keys.vector("position_offset"), keys.rotation("orientation_offset")};
    const yaml::View reference = entry.find("reference");
    if (!reference && X_LF == Pose{}) {
      std::vector<MujocoReading> readings;
      for (const std::string& name : names)
        readings.push_back({element, "objname", name, "/" + name});
      return add_readings(sensor, std::move(readings));
    }
    if (names.empty() || !can_afford(names.size() + 1, *sensor.name)) return false;
    MujocoReading reading{element, "objname", {}};
    if (reference) {
      const Pose X_LR{keys.vector("reference_position"), keys.rotation("reference_orientation")};
      if (!add(*sensor.name + "/reference", link(reference.text()), X_LR, {})) return false;
      reading.reference = sensors_.back().name;
    }
    for (const std::string& name : names)
      add(*sensor.name + "/" + name, link(name), X_LF, {reading});
    return true;
  }

  const LinkedModel& model_;
  std::vector<std::optional<Pose>> X_RL_;  ///< none: the root does not reach the link
  CollisionBoxes boxes_;
  std::map<const urdf::Joint*, std::string> motors_;
  std::set<std::string_view> known_;
  UniqueNames names_;
  std::size_t bytes_left_ = kMostReadingBytes;
  std::vector<MujocoSensor> sensors_;
};

}  // namespace

std::vector<MujocoSensor> mujoco_sensors(const LinkedModel& model, const MotorOptions& options) {
  return model.robot ? SensorReader(model, options).read() : std::vector<MujocoSensor>();
}

std::vector<xml::View> unsaid_by_mujoco(xml::View sensor) {
  std::vector<xml::View> unsaid;
  for (const xml::View child : sensor) {
    if (is_one_of(child.name(), {"pose", "origin", "parent"})) continue;
    if (!is_one_of(child.name(), {"camera", "ray", "lidar", "imu", "force_torque", "contact"})) {
      unsaid.push_back(child);
      continue;
    }
    for (const xml::View setting : child) {
      if (is_one_of(setting.name(),
                    {"horizontal_fov", "scan", "measure_direction", "frame", "collision"})) {
        continue;
      }
      if (setting.name() == "range" && !setting.child("min") && !setting.child("resolution")) {
        continue;
      }
      unsaid.push_back(setting);
    }
  }
  return unsaid;
}

bool is_said_by_mujoco(const Sensor& sensor, std::string_view key) {
  if (is_one_of(key, {"name", "type", "link", "joint", "id", "links", "joints"})) return true;
  const std::string type = sensor.type.value_or("");
  if (type == "RaySensor") return is_one_of(key, {"width", "opening_width", "max_distance"});
  if (type == "RotatingRaySensor") {
    return key != "min_distance" && passes::gazebo_says(sensor, key) && key != "rate";
  }
  if (type == "MultiLevelLaserRangeFinder") {
    return is_one_of(key, {"numRaysHorizontal", "numRaysVertical", "horizontalOpeningAngle",
                           "verticalOpeningAngle", "maxDistance"});
  }
  if (type == "NodeContact" || type == "NodeContactForce") return key == "collisions";
  if (is_one_of(type, {"NodePosition", "NodeVelocity", "NodeRotation", "NodeAngularVelocity"})) {
    return is_one_of(key, {"position_offset", "orientation_offset", "reference",
                           "reference_position", "reference_orientation"});
  }
  return type == "CameraSensor" &&
         is_one_of(key, {"opening_width", "opening_height", "opening_angle", "opening_angle2",
                         "position_offset", "orientation_offset"});
}

}  // namespace smurf
