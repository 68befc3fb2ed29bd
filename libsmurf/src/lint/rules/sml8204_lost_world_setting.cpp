// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8204_lost_world_setting_file {

extern constinit const Rule sml8204_lost_world_setting{
    .id = "SML8204",
    .name = "lost-world-setting",
    .severity = Severity::warning,
    .summary = "A setting of the world cannot be written in the format.",
    .why = "The simulator uses its own value.",
    .remedy = "Set it in the simulator.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8204_lost_world_setting_file
