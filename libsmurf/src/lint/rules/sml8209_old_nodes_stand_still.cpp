// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml8209_old_nodes_stand_still{
    .id = "SML8209",
    .name = "old-nodes-stand-still",
    .severity = Severity::warning,
    .summary = "Movable nodes of a scene of MARS before SMURF are written as shapes that stand "
               "still.",
    .why = "Nodes of old scenes hang together by joints and groups of their own, with masses that "
           "are densities as often as not; what is carried over is how they look and where they "
           "are.",
    .remedy = "Make a SMURF model of what has to move.",
    .sources = "MARS NodeData.cpp:98-286, Load.cpp:228-268.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
