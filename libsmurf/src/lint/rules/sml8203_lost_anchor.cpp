// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8203_lost_anchor_file {

extern constinit const Rule sml8203_lost_anchor{
    .id = "SML8203",
    .name = "lost-anchor",
    .severity = Severity::warning,
    .summary = "The anchor of an entity cannot be written in the format.",
    .why = "The entity is no longer fixed: it falls, or moves on its own.",
    .remedy = "Choose --form expand, or a format that joins models.",
    .sources = "SDFormat 1.9 world.sdf has no joints; MuJoCo 3 drops bodies inside attach (run).",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8203_lost_anchor_file
