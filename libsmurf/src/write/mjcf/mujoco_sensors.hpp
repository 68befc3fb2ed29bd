// SPDX-License-Identifier: BSD-3-Clause
// The sensors of a model that MuJoCo has too, from <gazebo> and from SMURF annotations.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"
#include "smurf/write_scene.hpp"

namespace smurf {

/// One element in <sensor> of MJCF.
struct MujocoReading {
  std::string_view element;  ///< "gyro"
  std::string_view
      object;             ///< attribute with the name of the measured object: "site", "joint", ...
  std::string name;       ///< measured joint, motor or link; "": the site of the sensor
  std::string part = {};  ///< suffix of the sensor's name: "/angular_velocity"
  double cutoff = 0;      ///< 0: none
  std::string reference = {};  ///< site in whose frame is measured; "": the world
};

struct MujocoSensor {
  std::string name;
  std::optional<std::size_t> link;  ///< the link that carries it
  Pose X_LS;                        ///< with the axes of MuJoCo
  std::optional<double> fovy;       ///< vertical opening of a camera, degrees
  std::optional<Vector3> reach;     ///< half extents of the box in which contacts are measured, m
  std::vector<MujocoReading> readings;
  const Sensor* annotation = nullptr;
  xml::ElementId element =
      xml::kNoElement;  ///< the <sensor> in <gazebo>; kNoElement for an annotation
};

/// Limit of the bytes that all sensors with several readings may add to one model. Each reading
/// repeats the name of its sensor; 4 MB are about 40,000 rays.
inline constexpr std::size_t kMostReadingBytes = 4'000'000;

/// Names are unique. Each ray of a scan, and each link of a contact sensor, becomes a separate
/// sensor. Omits annotations with the name of a <sensor> in <gazebo>, and sensors whose readings
/// exceed kMostReadingBytes. A sensor of the torque of a joint measures its motor, which `options`
/// may have added.
std::vector<MujocoSensor> mujoco_sensors(const LinkedModel& model, const MotorOptions& options);

/// The settings of a <sensor> in <gazebo> that MuJoCo does not have.
std::vector<xml::View> unsaid_by_mujoco(xml::View sensor);
/// Whether MuJoCo has the setting of a key in the annotation of such a sensor.
bool is_said_by_mujoco(const Sensor& sensor, std::string_view key);

}  // namespace smurf
