// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3306_xacro_missing_parameter_file {

extern constinit const Rule sml3306_xacro_missing_parameter{
    .id = "SML3306",
    .name = "xacro-missing-parameter",
    .severity = Severity::error,
    .summary = "A call of a macro lacks a parameter that has no default.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Add the parameter to the call, or give it a default in `params`.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3306_xacro_missing_parameter_file
