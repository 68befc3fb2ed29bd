// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3318_xacro_fatal_file {

extern constinit const Rule sml3318_xacro_fatal{
    .id = "SML3318",
    .name = "xacro-fatal",
    .severity = Severity::error,
    .summary = "The description stops the expansion with `xacro.fatal()`.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Change the call or the arguments with which the author of the description stops.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3318_xacro_fatal_file
