// SPDX-License-Identifier: BSD-3-Clause
// The sensors of a model that MuJoCo has counterparts of: those of <gazebo>, and those of SMURF.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/linked.hpp"

namespace smurf {

/// One element of <sensor>.
struct MujocoReading {
  std::string_view element;  ///< "gyro"
  std::string_view object;   ///< the attribute that names what is measured: "site", "joint", ...
  std::string name;          ///< of a joint, a motor or a link; "": the site of the sensor
  std::string part = {};     ///< after the name of the sensor: "/angular_velocity"
  double cutoff = 0;         ///< 0: none
};

struct MujocoSensor {
  std::string name;
  std::optional<std::size_t> link;  ///< that carries it
  Pose X_LS;                        ///< axes as MuJoCo has them
  std::optional<double> fovy;       ///< of a camera, degrees
  std::vector<MujocoReading> readings;
  const Sensor* annotation = nullptr;
  xml::ElementId element = xml::kNoElement;  ///< the <sensor> that says so; none of an annotation
};

/// Names are unique. Without annotations that have the name of such an element.
std::vector<MujocoSensor> mujoco_sensors(const LinkedModel& model);

/// The elements in a <sensor> of the above that MuJoCo has no counterpart of.
std::vector<xml::View> unsaid_by_mujoco(xml::View sensor);
/// Whether MuJoCo has what a key of the annotation of such a sensor says.
bool is_said_by_mujoco(const Sensor& sensor, std::string_view key);

}  // namespace smurf
