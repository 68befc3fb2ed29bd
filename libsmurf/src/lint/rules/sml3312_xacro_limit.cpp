// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3312_xacro_limit_file {

extern constinit const Rule sml3312_xacro_limit{.id = "SML3312",
                                                .name = "xacro-limit",
                                                .severity = Severity::error,
                                                .summary = "The expansion exceeds a limit.",
                                                .why = "A few lines can expand to gigabytes.",
                                                .remedy =
                                                    "Write a smaller robot, or raise the limit.",
                                                .sources = "xacro 2.1.1, run.",
                                                .blocks_building = true,
                                                .may_pass_elsewhere = true};

}  // namespace smurf::rules::sml3312_xacro_limit_file
