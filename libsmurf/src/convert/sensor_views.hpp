// SPDX-License-Identifier: BSD-3-Clause
// What sensors see: fields of view of cameras and rays of scans, in <gazebo> and in annotations.
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
  std::string_view why_unseen;  ///< why a field of view is not known; "" when there is none
};

/// Vertical opening of a camera in degrees, from the horizontal one and the size of the picture in
/// pixels; none when these are no opening and size.
std::optional<double> vertical_opening(double horizontal, double width, double height);
/// The same from the keys of a camera of MARS.
std::optional<double> vertical_opening(const SensorKeys& keys);

/// What a <sensor> in <gazebo> sees. A sensor of another kind than cameras and rays has a pose
/// only.
SensorView view_of(xml::View sensor);
/// What a sensor of the annotations sees, which has these keys. A scan has a farthest distance.
SensorView view_of(const Sensor& sensor, yaml::View keys);

}  // namespace smurf
