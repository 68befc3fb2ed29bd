// SPDX-License-Identifier: BSD-3-Clause
// The types of sensors of SDF.
#pragma once

#include <iterator>
#include <span>
#include <string_view>

namespace smurf {

inline constexpr std::string_view kSdfSensorTypes[] = {"air_pressure",
                                                       "altimeter",
                                                       "camera",
                                                       "contact",
                                                       "custom",
                                                       "depth",
                                                       "depth_camera",
                                                       "rgbd",
                                                       "rgbd_camera",
                                                       "thermal",
                                                       "thermal_camera",
                                                       "segmentation",
                                                       "boundingbox",
                                                       "boundingbox_camera",
                                                       "segmentation_camera",
                                                       "wideanglecamera",
                                                       "wide_angle_camera",
                                                       "force_torque",
                                                       "navsat",
                                                       "gps",
                                                       "gpu_ray",
                                                       "gpu_lidar",
                                                       "imu",
                                                       "logical_camera",
                                                       "magnetometer",
                                                       "multicamera",
                                                       "ray",
                                                       "lidar",
                                                       "rfid",
                                                       "rfidtag",
                                                       "sonar",
                                                       "wireless_receiver",
                                                       "wireless_transmitter",
                                                       "air_speed"};
/// Those of libsdformat 12, which has no `air_speed`.
inline constexpr auto kSdfSensorTypesOf12 =
    std::span(kSdfSensorTypes).first<std::size(kSdfSensorTypes) - 1>();

}  // namespace smurf
