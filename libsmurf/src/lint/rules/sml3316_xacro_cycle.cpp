// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3316_xacro_cycle_file {

extern constinit const Rule sml3316_xacro_cycle{
    .id = "SML3316",
    .name = "xacro-cycle",
    .severity = Severity::error,
    .summary = "Properties are defined by each other.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Compute one of them at its definition, with `lazy_eval=\"false\"`.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3316_xacro_cycle_file
