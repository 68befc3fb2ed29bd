// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3308_xacro_block_file {

extern constinit const Rule sml3308_xacro_block{
    .id = "SML3308",
    .name = "xacro-block",
    .severity = Severity::error,
    .summary = "A block is missing, is left over, or is not defined.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Give the call one child element for each block parameter, in their "
              "order.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3308_xacro_block_file
