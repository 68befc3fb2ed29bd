// SPDX-License-Identifier: BSD-3-Clause
// Words that SDF knows, in SDF files and in `<gazebo>`. Types of sensors: sdf_sensor_types.hpp.
// Sources: sdformat 12.3.0, the functions Load of Camera.cc, Noise.cc, Light.cc,
// ParticleEmitter.cc, Material.cc, Joint.cc and ForceTorque.cc.
#pragma once

#include <string_view>

namespace smurf::sdf {

/// Sensors that sdformat reads a `camera` of.
inline constexpr std::string_view kCameras[] = {"camera",
                                                "depth",
                                                "depth_camera",
                                                "rgbd",
                                                "rgbd_camera",
                                                "thermal",
                                                "boundingbox",
                                                "boundingbox_camera",
                                                "wideanglecamera",
                                                "wide_angle_camera",
                                                "segmentation",
                                                "thermal_camera",
                                                "segmentation_camera"};
inline constexpr std::string_view kPixels[] = {
    "L_INT8",    "L_INT16",     "RGB_INT8",    "RGBA_INT8",   "BGRA_INT8",   "RGB_INT16",
    "RGB_INT32", "BGR_INT8",    "BGR_INT16",   "BGR_INT32",   "R_FLOAT16",   "RGB_FLOAT16",
    "R_FLOAT32", "RGB_FLOAT32", "BAYER_RGGB8", "BAYER_BGGR8", "BAYER_GBRG8", "BAYER_GRBG8",
    "R8G8B8",    "L8",          "L16",         "B8G8R8"};
inline constexpr std::string_view kNoise[] = {"none", "gaussian", "gaussian_quantized"};
inline constexpr std::string_view kLights[] = {"point", "spot", "directional"};
inline constexpr std::string_view kEmitters[] = {"point", "box", "cylinder", "ellipsoid"};
inline constexpr std::string_view kShaders[] = {"pixel",
                                                "vertex",
                                                "normal_map_objectspace",
                                                "normal_map_object_space",
                                                "normal_map_tangentspace",
                                                "normal_map_tangent_space"};
inline constexpr std::string_view kJoints[] = {"ball",      "continuous", "fixed",
                                               "gearbox",   "prismatic",  "revolute",
                                               "revolute2", "screw",      "universal"};
inline constexpr std::string_view kWrenchFrames[] = {"parent", "child", "sensor"};
inline constexpr std::string_view kWrenchDirections[] = {"parent_to_child", "child_to_parent"};

}  // namespace smurf::sdf
