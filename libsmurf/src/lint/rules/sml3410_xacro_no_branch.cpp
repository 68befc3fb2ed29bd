// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3410_xacro_no_branch_file {

extern constinit const Rule sml3410_xacro_no_branch{
    .id = "SML3410",
    .name = "xacro-no-branch",
    .severity = Severity::warning,
    .summary = "An element has a branch for each of several values, and none for the "
               "actual one.",
    .why = "No condition holds, so the element is empty.",
    .remedy = "Correct the value, or add `<xacro:unless>` for all other values.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3410_xacro_no_branch_file
