// SPDX-License-Identifier: BSD-3-Clause
// The programs of ROS that load a URDF: urdfdom, RViz, MoveIt, KDL.
#include "base/readers.hpp"

namespace smurf::readers::ros_file {

extern constinit const Reader ros{.name = "ros",
                                  .title = "ROS",
                                  .basis = "as for urdfdom; MoveIt 1 (fdb79ac) read",
                                  .like = &urdfdom};

}  // namespace smurf::readers::ros_file
