// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6401_joint_comes_apart_file {

extern constinit const Rule sml6401_joint_comes_apart{
    .id = "SML6401",
    .name = "joint-comes-apart",
    .severity = Severity::error,
    .summary = "A joint comes apart under the weight of the robot.",
    .why = "The solver cannot balance the masses and inertias around the joint: the robot "
           "trembles, drifts or falls to pieces.",
    .remedy = "Look at the masses and inertias on both sides of the joint.",
    .sources = "ODE 0.16.2, executed: sound robots stay below 0.4 mm and 6e-3 rad at 1 ms.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6401_joint_comes_apart_file
