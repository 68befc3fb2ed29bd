// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3303_xacro_computation_file {

extern constinit const Rule sml3303_xacro_computation{
    .id = "SML3303",
    .name = "xacro-computation",
    .severity = Severity::error,
    .summary = "An expression cannot be computed: wrong kinds of values, a division by "
               "zero, an absent key.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Correct the expression or the values that it uses.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3303_xacro_computation_file
