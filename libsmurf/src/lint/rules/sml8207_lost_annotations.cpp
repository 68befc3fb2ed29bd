// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8207_lost_annotations_file {

extern constinit const Rule sml8207_lost_annotations{
    .id = "SML8207",
    .name = "lost-annotations",
    .severity = Severity::info,
    .summary = "Annotations, or keys of an entity, have no place in the format.",
    .why =
        "Motors, sensors and similar annotations are specific to SMURF; other simulators keep them in other files.",
    .remedy = "Set them up in the simulator.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8207_lost_annotations_file
