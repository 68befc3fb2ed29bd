// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3406_xacro_truth_as_text_file {

extern constinit const Rule sml3406_xacro_truth_as_text{
    .id = "SML3406",
    .name = "xacro-truth-as-text",
    .severity = Severity::warning,
    .summary = "A truth value is compared with a text such as 'true', which is never "
               "equal.",
    .why = "A property or argument with the value `true` is a truth value, so `a == "
           "'true'` is false whatever its value is.",
    .remedy = "Write `a` or `a == True` instead of `a == 'true'`, and `not a` instead of "
              "`a == 'false'`.",
    .sources = "xacro 2.1.1, run; ros/xacro issue 145."};

}  // namespace smurf::rules::sml3406_xacro_truth_as_text_file
