// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3307_xacro_surplus_parameter_file {

extern constinit const Rule sml3307_xacro_surplus_parameter{
    .id = "SML3307",
    .name = "xacro-surplus-parameter",
    .severity = Severity::error,
    .summary = "A call of a macro has a parameter that the macro does not have.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Delete the attribute, or correct its name.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3307_xacro_surplus_parameter_file
