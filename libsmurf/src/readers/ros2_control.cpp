// SPDX-License-Identifier: BSD-3-Clause
// The resource manager of ros2_control, which reads the elements `ros2_control` of a URDF.
#include "base/readers.hpp"

namespace smurf::readers::ros2_control_file {

extern constinit const Reader ros2_control{
    .name = "ros2_control",
    .title = "ros2_control",
    .basis = "53b9999 (2026-08) and its branches humble, jazzy and kilted read; as for urdfdom",
    .like = &urdfdom};

}  // namespace smurf::readers::ros2_control_file
