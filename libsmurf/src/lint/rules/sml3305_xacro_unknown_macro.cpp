// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3305_xacro_unknown_macro_file {

extern constinit const Rule sml3305_xacro_unknown_macro{
    .id = "SML3305",
    .name = "xacro-unknown-macro",
    .severity = Severity::error,
    .summary = "An element calls a macro that does not exist.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Include the file that defines the macro before the call, or correct the "
              "name.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3305_xacro_unknown_macro_file
