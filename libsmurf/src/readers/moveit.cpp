// SPDX-License-Identifier: BSD-3-Clause
// MoveIt 2: a robot with its SRDF and its parameter files.
#include "base/findings/readers.hpp"

namespace smurf::readers::moveit_file {

extern constinit const Reader moveit{.name = "moveit",
                                     .title = "MoveIt",
                                     .basis = "MoveIt 2 8fcb5d2 (2026-08) read, srdfdom e23af6e "
                                              "(2024-10) run; as for urdfdom",
                                     .like = &urdfdom};

}  // namespace smurf::readers::moveit_file
