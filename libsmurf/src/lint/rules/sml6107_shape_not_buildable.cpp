// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6107_shape_not_buildable_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "leaves the whole node out", "MARS NodePhysics.cpp:626-634"},
};

}  // namespace

extern constinit const Rule sml6107_shape_not_buildable{
    .id = "SML6107",
    .name = "shape-not-buildable",
    .severity = Severity::error,
    .summary = "ODE cannot build a collision shape.",
    .why = "ODE stops at a shape without extent.",
    .remedy =
        "Give the shape a positive size, or export the mesh or the heightmap again. Heightmaps are "
        "read from PNG files.",
    .sources = "ODE 0.16.2 dCreateBox and its siblings; assimp 5.2; libpng 1.6.",
    .facts = kFacts,
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6107_shape_not_buildable_file
