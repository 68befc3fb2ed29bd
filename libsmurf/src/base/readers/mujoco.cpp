// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo, which has its own URDF reader.
#include "base/readers.hpp"

namespace smurf::readers::mujoco_file {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML18", {&mujoco, refuses, "refuses the number", kRun}},
};

constexpr std::string_view kVisuals = "discards visuals, except for their materials";
constexpr std::string_view kIgnores = "does not look at it";

constexpr Fact kUnread[] = {
    {&mujoco, ignores, kVisuals, "MuJoCo (discardvisual), run", "/visual/origin/"},
    {&mujoco, ignores, kVisuals, "MuJoCo (discardvisual), run", "/visual/geometry/"},
    {&mujoco, ignores, "gives the world no mass", kRun, "#of-world"},
    {&mujoco, ignores, kIgnores, kRun, "#in-fixed/limit/"},
    {&mujoco, ignores, kIgnores, kRun, "#in-fixed/dynamics/"},
    {&mujoco, ignores, kIgnores, kRun, "#in-fixed/mimic/"},
    {&mujoco, ignores, kIgnores, kRun, "#in-floating/mimic/"},
    {&mujoco, ignores, kIgnores, kRun, "/texture/"},
    {&mujoco, ignores, kIgnores, kRun, "/calibration/"},
    {&mujoco, ignores, kIgnores, kRun, "/safety_controller/"},
    {&mujoco, ignores, kIgnores, kRun, "/limit/@velocity/"},
    {&mujoco, ignores, kIgnores, kRun, "/robot/@version/"},
    {&mujoco, ignores, kIgnores, kRun, "/transmission/"},
    {&mujoco, ignores, kIgnores, kRun, "/gazebo/"},
};

}  // namespace

extern constinit const Reader mujoco{.name = "mujoco",
                                     .title = "MuJoCo",
                                     .basis = "3.14.0 (npm), executed; a725507 (about 3.12) read",
                                     .like = &urdf,
                                     .version = "MuJoCo 3.14",
                                     .families = kFamilies,
                                     .unread = kUnread};

}  // namespace smurf::readers::mujoco_file
