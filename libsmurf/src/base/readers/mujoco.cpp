// SPDX-License-Identifier: BSD-3-Clause
// MuJoCo, by its own reader of URDF.
#include "base/readers.hpp"

namespace smurf::readers {
namespace {

using enum Effect;

constexpr FamilyFact kFamilies[] = {
    {"SML18", {&mujoco, refuses, "refuses the number", kRun}},
};

}  // namespace

extern constinit const Reader mujoco{.name = "mujoco",
                                     .title = "MuJoCo",
                                     .basis = "3.14.0 (npm), executed; a725507 (about 3.12) read",
                                     .like = &urdf,
                                     .version = "MuJoCo 3.14",
                                     .families = kFamilies};

}  // namespace smurf::readers
