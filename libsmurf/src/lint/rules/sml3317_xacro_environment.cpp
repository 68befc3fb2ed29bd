// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3317_xacro_environment_file {

extern constinit const Rule sml3317_xacro_environment{
    .id = "SML3317",
    .name = "xacro-environment",
    .severity = Severity::error,
    .summary = "`$(env ...)` names a variable of the environment that may not be read, "
               "or is not set.",
    .why = "A robot description of a stranger could print secrets of the environment "
           "into a report.",
    .remedy = "Allow it with `--xacro-env NAME`, or use an argument.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

}  // namespace smurf::rules::sml3317_xacro_environment_file
