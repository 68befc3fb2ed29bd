// SPDX-License-Identifier: BSD-3-Clause
// Gazebo, which reads URDF with sdformat, which reads it with urdfdom.
#include "base/readers.hpp"

namespace smurf::readers::gazebo_file {

extern constinit const Reader gazebo{.name = "gazebo",
                                     .title = "Gazebo",
                                     .basis = "sdformat 12.3.0, executed; 17 (2ace536) read",
                                     .like = &urdfdom,
                                     .version = "sdformat 12.3"};

}  // namespace smurf::readers::gazebo_file
