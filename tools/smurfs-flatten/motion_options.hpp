// SPDX-License-Identifier: BSD-3-Clause
// Options for how a robot moves, and what it touches.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "common/cli/command.hpp"
#include "smurf/write_scene.hpp"

namespace smurf::tools {

/// The options --actuator, --kp, --kv and --armature, which write into `motors`, and --controllers.
/// `help` is the text of --actuator. All must live as long as the options.
std::vector<Option> motor_options(MotorOptions& motors, std::string& controllers,
                                  std::string_view help);
/// --self-collision, --srdf and --exclude-overlaps.
std::vector<Option> contact_options(SelfCollision& choice, std::string& srdf,
                                    bool& excludes_overlaps);

}  // namespace smurf::tools
