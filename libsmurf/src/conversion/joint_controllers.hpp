// SPDX-License-Identifier: BSD-3-Clause
// Which controllers of ros2_control command the joints of a scene, and with which gains.
#pragma once

#include "conversion/own_companions.hpp"
#include "smurf/conversion.hpp"

namespace smurf {

/// Adds what the controllers say to `motors`: those in the file of the request, else in the files
/// that belong to the models by evidence. Of two controllers of one joint, the first one counts: of
/// the file with the stronger evidence, in the order of a file. SMURF motors that state gains, and
/// a kind that `motors` asks for, are kept. Reports what was chosen; refuses a file without
/// controllers of these joints.
Refusal add_controllers(LoadedScene& loaded, const SceneRequest& request, OwnCompanions& companions,
                        MotorOptions& motors);

}  // namespace smurf
