// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6601_anchor_moves_file {

extern constinit const Rule sml6601_anchor_moves{
    .id = "SML6601",
    .name = "anchor-moves",
    .severity = Severity::error,
    .summary = "An anchored entity moves relative to its anchor.",
    .why = "An anchor that gives way makes every pose in the scene wrong.",
    .remedy = "Look at the masses of the two models.",
    .sources = "ODE 0.16.2, executed.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6601_anchor_moves_file
