// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml6107_shape_not_buildable{
    .id = "SML6107",
    .name = "shape-not-buildable",
    .severity = Severity::error,
    .summary = "ODE cannot build a collision shape.",
    .why = "ODE stops at a shape without extent; MARS leaves the whole node out.",
    .remedy =
        "Give the shape a positive size, or export the mesh or the heightmap again. Heightmaps are "
        "read from PNG files.",
    .sources = "ODE 0.16.2 dCreateBox and its siblings; assimp 5.2; libpng 1.6.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules
