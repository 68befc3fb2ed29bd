// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml8201_lost_entity{
    .id = "SML8201",
    .name = "lost-entity",
    .severity = Severity::warning,
    .summary = "An entity of the scene cannot be written in the format.",
    .why = "What a plug-in makes of its own types of entities no other simulator knows.",
    .remedy = "Use a model or a primitive for what has to arrive, or the format json, which "
              "carries all keys along.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
