// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6301_zero_outside_limits_file {

extern constinit const Rule sml6301_zero_outside_limits{
    .id = "SML6301",
    .name = "zero-outside-limits",
    .severity = Severity::warning,
    .summary = "The zero position of a joint, or its position in a pose, is outside its limits.",
    .why =
        "Simulators start with all joints at zero. A joint whose limits exclude zero is thrown to the nearest limit in the first steps. The check starts it at the nearest allowed position.",
    .remedy = "Give the model a joint pose within the limits, or start the simulation there.",
    .sources = "ODE 0.16.2, executed on 307 robots: all that move at rest have such a joint.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6301_zero_outside_limits_file
