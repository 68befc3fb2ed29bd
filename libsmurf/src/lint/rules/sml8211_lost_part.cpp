// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8211_lost_part_file {

extern constinit const Rule sml8211_lost_part{
    .id = "SML8211",
    .name = "lost-part",
    .severity = Severity::warning,
    .summary =
        "A part of a model or of an entity is not in the result, or is written as something else.",
    .why =
        "The simulator does not get what the format cannot express, such as velocity limits of joints or plug-ins in `<gazebo>` elements.",
    .remedy =
        "Set it up in the simulator, or choose a format that keeps it; docs/scene-formats.md has "
        "the table.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8211_lost_part_file
