// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8201_lost_entity_file {

extern constinit const Rule sml8201_lost_entity{
    .id = "SML8201",
    .name = "lost-entity",
    .severity = Severity::warning,
    .summary = "An entity of the scene cannot be written in the format.",
    .why = "Only the plug-in of the type knows how to build the entity.",
    .remedy = "Use a model or a primitive instead, or the format json, which keeps all keys.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8201_lost_entity_file
