// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3313_xacro_unknown_argument_file {

extern constinit const Rule sml3313_xacro_unknown_argument{
    .id = "SML3313",
    .name = "xacro-unknown-argument",
    .severity = Severity::error,
    .summary = "`$(arg ...)` names an argument that has no value.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Define it with `<xacro:arg>` before it is used, or give it a value: "
              "`name:=value`.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

}  // namespace smurf::rules::sml3313_xacro_unknown_argument_file
