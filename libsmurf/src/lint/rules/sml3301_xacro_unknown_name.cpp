// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3301_xacro_unknown_name_file {

extern constinit const Rule sml3301_xacro_unknown_name{
    .id = "SML3301",
    .name = "xacro-unknown-name",
    .severity = Severity::error,
    .summary = "An expression names a property or function that does not exist.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Define the property before it is used, or correct the name.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3301_xacro_unknown_name_file
