// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8209_old_nodes_stand_still_file {

extern constinit const Rule sml8209_old_nodes_stand_still{
    .id = "SML8209",
    .name = "old-nodes-stand-still",
    .severity = Severity::warning,
    .summary = "Movable nodes of a scene of MARS before SMURF are written as shapes that stand "
               "still.",
    .why =
        "Old scenes connect nodes by joints and groups, and often give densities as masses. Only shapes and poses are converted.",
    .remedy = "Make a SMURF model of everything that has to move.",
    .sources = "MARS NodeData.cpp:98-286, Load.cpp:228-268.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8209_old_nodes_stand_still_file
