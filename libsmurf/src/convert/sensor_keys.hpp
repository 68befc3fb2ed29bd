// SPDX-License-Identifier: BSD-3-Clause
// The numbers in the keys of a sensor annotation, with the defaults of MARS for cameras.
#pragma once

#include <optional>
#include <string_view>

#include "smurf/pose.hpp"
#include "smurf/yaml.hpp"

namespace smurf {

class SensorKeys {
 public:
  explicit SensorKeys(yaml::View keys) : keys_(keys) {}

  /// None if the key is absent, not a number, or too large for computations.
  std::optional<double> find(std::string_view key) const;
  double number(std::string_view key, double fallback) const;
  /// x, y and z below a key, 0 if absent, in m.
  Vector3 vector(std::string_view key) const;
  /// Roll, pitch and yaw in rad, from angles in degrees below a key or from its quaternion.
  Vector3 rpy(std::string_view key) const;
  /// The same rotation as a unit quaternion.
  Quaternion rotation(std::string_view key) const;

  /// A camera: its pose on the link, its opening in degrees, and its picture size in pixels.
  Pose camera_pose() const { return {vector("position_offset"), rotation("orientation_offset")}; }
  double camera_opening() const { return number("opening_angle", number("opening_width", 90)); }
  double camera_width() const { return number("width", 640); }
  double camera_height() const { return number("height", 480); }

 private:
  double part(std::string_view key, std::string_view component, double fallback) const;
  /// Roll, pitch and yaw in degrees; none if the key has no roll.
  std::optional<Vector3> angles(std::string_view key) const;
  Quaternion quaternion(std::string_view key) const;

  yaml::View keys_;
};

}  // namespace smurf
