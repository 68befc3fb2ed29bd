// SPDX-License-Identifier: BSD-3-Clause
// The sensors of a MuJoCo world: cameras and sites in bodies, and the elements of <sensor>.
#pragma once

#include <map>
#include <vector>

#include "base/text/unique_names.hpp"
#include "write/mjcf/mjcf_actuators.hpp"
#include "write/mjcf/mujoco_sensors.hpp"

namespace smurf {

/// What is written for each instance: sensors, motors but for those that options add, and names.
RepeatedParts mjcf_repeated_parts(const LinkedModel& model);

class MjcfSensors : protected MjcfActuators {
 public:
  using MjcfActuators::MjcfActuators;

 protected:
  /// Writes the cameras and sites in the body of a link.
  void add_mounts(std::size_t instance, std::size_t link);
  /// Writes <sensor>.
  void add_sensors();

 private:
  struct OfModel {
    std::vector<MujocoSensor> sensors;
    std::multimap<std::size_t, std::size_t> by_link;
  };

  const OfModel& sensors_of(const LinkedModel& model);
  void add_reading(std::size_t instance, const MujocoSensor& sensor, const MujocoReading& reading);

  std::map<const LinkedModel*, OfModel> of_model_;
  UniqueNames sensor_names_;
  bool is_open_ = false;
};

}  // namespace smurf
