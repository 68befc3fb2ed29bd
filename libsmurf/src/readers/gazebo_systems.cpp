// SPDX-License-Identifier: BSD-3-Clause
// Sources: gz-sim SystemLoader.cc and src/systems of the branches ign-gazebo6 (Fortress), gz-sim7,
// gz-sim8, gz-sim9 and gz-sim10 (Jetty), read; gazebo_ros_pkgs, branch ros2, read.
#include "readers/gazebo_systems.hpp"

#include <algorithm>
#include <iterator>

#include "base/text/lists.hpp"
#include "base/text/words.hpp"

namespace smurf::gazebo {
namespace {

constexpr System kSystems[] = {
    {"ackermann-steering", "", kAll},
    {"acoustic-comms", "", "GHIJ"},
    {"advanced-lift-drag", "", "GHIJ"},
    {"air-pressure", "", kAll},
    {"air-speed", "", "GHIJ"},
    {"altimeter", "", kAll},
    {"apply-joint-force", "", kAll},
    {"apply-link-wrench", "", kAll},
    {"breadcrumbs", "", kAll},
    {"buoyancy", "", kAll},
    {"buoyancy-engine", "", kAll},
    {"camera-video-recorder", "", kAll},
    {"collada-world-exporter", "", kAll},
    {"comms-endpoint", "", kAll},
    {"contact", "", kAll},
    {"detachable-joint", "", kAll},
    {"diff-drive", "", kAll},
    {"drive-to-pose-controller", "", "IJ"},
    {"dvl", "DopplerVelocityLogSystem", "HIJ"},
    {"elevator", "", kAll},
    {"entity-semantics", "", "HIJ"},
    {"environment-preload", "", "GHIJ"},
    {"environmental-sensor", "EnvironmentalSystem", "GHIJ"},
    {"follow-actor", "", kAll},
    {"forcetorque", "ForceTorque", kAll},
    {"free-space-explorer", "", "J"},
    {"hydrodynamics", "", kAll},
    {"imu", "", kAll},
    {"joint-controller", "", kAll},
    {"joint-position-controller", "", kAll},
    {"joint-state-publisher", "", kAll},
    {"joint-trajectory-controller", "", kAll},
    {"kinetic-energy-monitor", "", kAll},
    {"label", "", kAll},
    {"lens-flare", "", "HIJ"},
    {"lift-drag", "", kAll},
    {"lighter_than_air_dynamics", "LighterThanAirDynamics", "GHIJ"},
    {"linearbatteryplugin", "LinearBatteryPlugin", kAll},
    {"log", "LogRecord", kAll},
    {"log-video-recorder", "", kAll},
    {"logical-camera", "", kAll},
    {"logicalaudiosensorplugin", "LogicalAudioSensorPlugin", kAll},
    {"lookup-wheel-slip", "", "J"},
    {"magnetometer", "", kAll},
    {"mecanum-drive", "", kAll},
    {"model-photo-shoot", "", kAll},
    {"multicopter-control", "MulticopterVelocityControl", kAll},
    {"multicopter-motor-model", "", kAll},
    {"navsat", "NavSat", kAll},
    {"odometry-publisher", "", kAll},
    {"opticaltactileplugin", "OpticalTactilePlugin", kAll},
    {"particle-emitter", "", kAll},
    {"particle-emitter2", "ParticleEmitter2", "FG"},
    {"perfect-comms", "", kAll},
    {"performer-detector", "", kAll},
    {"physics", "", kAll},
    {"pose-publisher", "", kAll},
    {"python-system-loader", "", "HIJ"},
    {"rf-comms", "RFComms", kAll},
    {"scene-broadcaster", "", kAll},
    {"sensors", "", kAll},
    {"shader-param", "", kAll},
    {"spacecraft-thruster-model", "", "GHIJ"},
    {"thermal", "", kAll},
    {"thermal-sensor", "", kAll},
    {"thruster", "", kAll},
    {"touchplugin", "TouchPlugin", kAll},
    {"track-controller", "", kAll},
    {"tracked-vehicle", "", kAll},
    {"trajectory-follower", "", kAll},
    {"triggered-publisher", "", kAll},
    {"user-commands", "", kAll},
    {"velocity-control", "", kAll},
    {"websocket-server", "", "J"},
    {"wheel-slip", "", kAll},
    {"wind-effects", "", kAll},
};

constexpr Needs kNeeds[] = {
    {"diff-drive", "left_joint right_joint"},
    {"ackermann-steering", "left_joint right_joint left_steering_joint right_steering_joint"},
    {"mecanum-drive", "front_left_joint front_right_joint back_left_joint back_right_joint"},
    {"joint-position-controller", "joint_name"},
    {"joint-controller", "joint_name"},
    {"touchplugin", "target time namespace"},
    {"detachable-joint", "parent_link child_link"},
    {"multicopter-motor-model", "jointName linkName"},
    {"lift-drag", "link_name"},
    {"thruster", "joint_name"},
    {"linearbatteryplugin", "battery_name voltage"},
};

constexpr OldWord kOldWords[] = {
    {"diff-drive", "wheel_diameter", "wheel_radius", 0.5},
    {"diff-drive", "odometry_frame", "frame_id"},
    {"diff-drive", "robot_base_frame", "child_frame_id"},
    {"diff-drive", "odometry_topic", "odom_topic"},
    {"diff-drive", "command_topic", "topic"},
    {"diff-drive", "update_rate", "odom_publish_frequency"},
    {"diff-drive", "updateRate", "odom_publish_frequency"},
    {"diff-drive", "max_wheel_acceleration", "max_linear_acceleration"},
    {"ackermann-steering", "odometry_frame", "frame_id"},
    {"ackermann-steering", "robot_base_frame", "child_frame_id"},
    {"odometry-publisher", "frame_id", "odom_frame"},
    {"odometry-publisher", "child_frame_id", "robot_base_frame"},
    {"odometry-publisher", "body_name", "robot_base_frame"},
    {"odometry-publisher", "update_rate", "odom_publish_frequency"},
    {"mecanum-drive", "wheel_base", "wheelbase"},
};

constexpr ClassicPlugin kClassic[] = {
    {"libgazebo_ros_bumper.so", "a sensor of type `contact` and `gz-sim-contact-system`"},
    {"libgazebo_ros_control.so", "`gz_ros2_control-system`"},
    {"libgazebo_ros2_control.so", "`gz_ros2_control-system`"},
    {"libgazebo_ros_imu.so", "a sensor of type `imu` and `gz-sim-imu-system`"},
    {"libgazebo_ros_imu_sensor.so", "a sensor of type `imu` and `gz-sim-imu-system`"},
    {"libgazebo_ros_camera.so", "a sensor of type `camera` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_multicamera.so", "a sensor of type `camera` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_depth_camera.so",
     "a sensor of type `depth_camera` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_openni_kinect.so",
     "a sensor of type `rgbd_camera` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_ray_sensor.so", "a sensor of type `gpu_lidar` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_laser.so", "a sensor of type `gpu_lidar` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_gpu_laser.so", "a sensor of type `gpu_lidar` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_block_laser.so", "a sensor of type `gpu_lidar` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_range.so", "a sensor of type `gpu_lidar` and `gz-sim-sensors-system`"},
    {"libgazebo_ros_p3d.so", "`gz-sim-odometry-publisher-system`"},
    {"libgazebo_ros_diff_drive.so", "`gz-sim-diff-drive-system`"},
    {"libgazebo_ros_skid_steer_drive.so", "`gz-sim-diff-drive-system`"},
    {"libgazebo_ros_joint_state_publisher.so", "`gz-sim-joint-state-publisher-system`"},
    {"libgazebo_ros_ackermann_drive.so", "`gz-sim-ackermann-steering-system`"},
    {"libgazebo_ros_tricycle_drive.so", "`gz-sim-ackermann-steering-system`"},
    {"libgazebo_ros_planar_move.so",
     "`gz-sim-velocity-control-system` and `gz-sim-odometry-publisher-system`"},
    {"libgazebo_ros_ft_sensor.so",
     "a sensor of type `force_torque` and `gz-sim-forcetorque-system`"},
    {"libgazebo_ros_f3d.so", "a sensor of type `force_torque` and `gz-sim-forcetorque-system`"},
    {"libgazebo_ros_gps_sensor.so", "a sensor of type `navsat` and `gz-sim-navsat-system`"},
    {"libgazebo_ros_force.so", "`gz-sim-apply-link-wrench-system`"},
    {"libgazebo_ros_joint_pose_trajectory.so", "`gz-sim-joint-trajectory-controller-system`"},
    {"libgazebo_ros_wheel_slip.so", "`gz-sim-wheel-slip-system`"},
    {"libgazebo_ros_elevator.so", "`gz-sim-elevator-system`"},
};

/// SdfEntityCreator.cc and the systems: which of them makes the sensors of a type.
constexpr struct {
  std::string_view type, system;
} kOfSensors[] = {
    {"camera", "sensors"},
    {"depth_camera", "sensors"},
    {"depth", "sensors"},
    {"rgbd_camera", "sensors"},
    {"rgbd", "sensors"},
    {"gpu_lidar", "sensors"},
    {"gpu_ray", "sensors"},
    {"thermal_camera", "sensors"},
    {"thermal", "sensors"},
    {"segmentation_camera", "sensors"},
    {"segmentation", "sensors"},
    {"boundingbox_camera", "sensors"},
    {"boundingbox", "sensors"},
    {"wide_angle_camera", "sensors"},
    {"imu", "imu"},
    {"altimeter", "altimeter"},
    {"air_pressure", "air-pressure"},
    {"air_speed", "air-speed"},
    {"magnetometer", "magnetometer"},
    {"navsat", "navsat"},
    {"gps", "navsat"},
    {"force_torque", "forcetorque"},
    {"contact", "contact"},
    {"logical_camera", "logical-camera"},
};

constexpr struct {
  char letter;
  std::string_view name;
  const Circumstance* missing;
} kReleases[] = {
    {'F', "Fortress", &kNotInFortress}, {'G', "Garden", &kNotInGarden},
    {'H', "Harmonic", &kNotInHarmonic}, {'I', "Ionic", &kNotInIonic},
    {'J', "Jetty", &kNotInJetty},
};

}  // namespace

std::string release_names(std::string_view releases) {
  std::vector<std::string_view> names;
  for (const auto& one : kReleases) {
    if (releases.find(one.letter) != std::string_view::npos) names.push_back(one.name);
  }
  return enumerated(names);
}

void mark_missing(std::string_view releases, Diagnostic& found) {
  for (const auto& one : kReleases) {
    if (releases.find(one.letter) != std::string_view::npos) found.when(*one.missing);
  }
}

std::span<const System> systems() { return kSystems; }

std::string class_of(const System& system) {
  if (!system.cls.empty()) return std::string(system.cls);
  std::string name;
  bool is_first = true;
  for (const char c : system.name) {
    const bool is_letter = c >= 'a' && c <= 'z';
    if (c != '-') name += is_first && is_letter ? static_cast<char>(c - 'a' + 'A') : c;
    is_first = c == '-';
  }
  return name;
}

const System* find_system(std::string_view name) {
  const auto* found = std::find_if(std::begin(kSystems), std::end(kSystems),
                                   [&](const System& one) { return one.name == name; });
  return found == std::end(kSystems) ? nullptr : found;
}

std::optional<Library> library_of(std::string_view filename) {
  Library library;
  if (filename.starts_with("lib")) filename.remove_prefix(3);
  if (filename.ends_with(".so")) filename.remove_suffix(3);
  for (const std::string_view begin : {"gz-sim", "ignition-gazebo"}) {
    if (!filename.starts_with(begin)) continue;
    library.is_old = begin.front() == 'i';
    filename.remove_prefix(begin.size());
    while (!filename.empty() && filename.front() >= '0' && filename.front() <= '9')
      filename.remove_prefix(1);
    if (!filename.starts_with('-') || !filename.ends_with("-system")) return std::nullopt;
    filename.remove_prefix(1);
    if (filename.size() <= 7) return std::nullopt;
    library.name = filename.substr(0, filename.size() - 7);
    return library;
  }
  return std::nullopt;
}

std::span<const Needs> needs() { return kNeeds; }
std::span<const OldWord> old_words() { return kOldWords; }

const ClassicPlugin* find_classic(std::string_view filename) {
  const auto* found = std::find_if(std::begin(kClassic), std::end(kClassic),
                                   [&](const ClassicPlugin& one) { return one.file == filename; });
  return found == std::end(kClassic) ? nullptr : found;
}

bool is_classic(std::string_view filename) {
  return filename.starts_with("libgazebo_ros") && filename.ends_with(".so");
}

std::string_view system_of_sensor(std::string_view type) {
  for (const auto& one : kOfSensors) {
    if (one.type == type) return one.system;
  }
  return {};
}

}  // namespace smurf::gazebo
