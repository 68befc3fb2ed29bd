// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3314_xacro_condition_file {

extern constinit const Rule sml3314_xacro_condition{
    .id = "SML3314",
    .name = "xacro-condition",
    .severity = Severity::error,
    .summary = "The condition of `xacro:if` or `xacro:unless` is not a truth value.",
    .why = "xacro stops, so there is no robot. Texts must be `true`, `false` or an "
           "integer; `1.0`, `yes` and an empty text are errors.",
    .remedy = "Write a condition that is `true`, `false` or a comparison.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3314_xacro_condition_file
