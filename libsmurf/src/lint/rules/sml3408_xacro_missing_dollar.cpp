// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3408_xacro_missing_dollar_file {

extern constinit const Rule sml3408_xacro_missing_dollar{
    .id = "SML3408",
    .name = "xacro-missing-dollar",
    .severity = Severity::warning,
    .summary = "Braces around a known name have no `$` before them.",
    .why = "Without the `$`, `{...}` is a text like any other, and reaches the reader "
           "of the robot.",
    .remedy = "Write `${...}`.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3408_xacro_missing_dollar_file
