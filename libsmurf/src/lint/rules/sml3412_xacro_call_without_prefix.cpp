// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3412_xacro_call_without_prefix_file {

extern constinit const Rule sml3412_xacro_call_without_prefix{
    .id = "SML3412",
    .name = "xacro-call-without-prefix",
    .severity = Severity::warning,
    .summary = "An element has the name and the parameters of a macro, and no prefix.",
    .why = "Old versions of xacro called the macro; today, the element is copied, and "
           "readers of the robot ignore it.",
    .remedy = "Write `<xacro:NAME .../>`.",
    .sources = "xacro 2.1.1, run; xacro 1.11 accepted it."};

}  // namespace smurf::rules::sml3412_xacro_call_without_prefix_file
