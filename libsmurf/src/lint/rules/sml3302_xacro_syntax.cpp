// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3302_xacro_syntax_file {

extern constinit const Rule sml3302_xacro_syntax{
    .id = "SML3302",
    .name = "xacro-syntax",
    .severity = Severity::error,
    .summary = "The text between `${` and `}` is not an expression.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Correct the expression at the marked place.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3302_xacro_syntax_file
