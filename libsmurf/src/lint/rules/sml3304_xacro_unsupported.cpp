// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3304_xacro_unsupported_file {

extern constinit const Rule sml3304_xacro_unsupported{
    .id = "SML3304",
    .name = "xacro-unsupported",
    .severity = Severity::error,
    .summary = "An expression uses a part of Python that is not supported.",
    .why = "Expressions are computed without Python. Unknown parts are reported, "
           "never guessed.",
    .remedy = "Write the expression with the supported parts of the language.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

}  // namespace smurf::rules::sml3304_xacro_unsupported_file
