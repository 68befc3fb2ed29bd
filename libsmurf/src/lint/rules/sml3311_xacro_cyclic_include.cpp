// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3311_xacro_cyclic_include_file {

extern constinit const Rule sml3311_xacro_cyclic_include{
    .id = "SML3311",
    .name = "xacro-cyclic-include",
    .severity = Severity::error,
    .summary = "A file includes itself, directly or through other files.",
    .why = "xacro never terminates on it, or stops at the depth of Python's stack.",
    .remedy = "Delete the include, or make it depend on a condition.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3311_xacro_cyclic_include_file
