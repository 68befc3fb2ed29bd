// SPDX-License-Identifier: BSD-3-Clause
// Options for how a robot moves, and what it touches.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/cli/command.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// --actuator, with this help, --kp, --kv and --armature. The results refer to the arguments.
std::vector<Option> motor_options(MotorOptions& motors, std::string_view help);
/// --self-collision, --srdf and --exclude-overlaps.
std::vector<Option> contact_options(SelfCollision& choice, std::string& srdf,
                                    bool& excludes_overlaps);

}  // namespace smurf::tools
