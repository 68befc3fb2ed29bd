// SPDX-License-Identifier: BSD-3-Clause
// Fields of view of cameras and rays of scans, from <gazebo> and from annotations.
#pragma once

#include <optional>

#include "convert/sensor_keys.hpp"
#include "smurf/model.hpp"
#include "smurf/xml.hpp"

namespace smurf {

/// Cameras look along x, with z up.
struct CameraView {
  double width = 0, height = 0;             ///< openings in rad, below pi
  std::optional<double> nearest, farthest;  ///< m
};

/// Rays at equal angles.
struct RayFan {
  double lowest = 0, highest = 0;  ///< rad
  double count = 1;                ///< whole
};

/// The ray in the middle goes along x.
struct ScanView {
  RayFan across;                            ///< about z
  RayFan up;                                ///< positive looks up
  std::optional<double> nearest, farthest;  ///< m
};

struct SensorView {
  Pose X_LS;
  std::optional<CameraView> camera;
  std::optional<ScanView> scan;
  std::string_view why_unseen;  ///< the reason why a field of view is unknown; "" if it is known
};

/// Vertical opening of a camera in degrees, from the horizontal opening and the size of the picture
/// in pixels; none if these are invalid.
std::optional<double> vertical_opening(double horizontal, double width, double height);
/// The same from the keys of a camera of MARS.
std::optional<double> vertical_opening(const SensorKeys& keys);

/// The view of a <sensor> in <gazebo>. Sensors other than cameras and rays have only a
/// pose.
SensorView view_of(xml::View sensor);
/// The view of a sensor of the annotations with these keys. A scan has a farthest distance.
SensorView view_of(const Sensor& sensor, yaml::View keys);

}  // namespace smurf
