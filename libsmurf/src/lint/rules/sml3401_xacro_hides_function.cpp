// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3401_xacro_hides_function_file {

extern constinit const Rule sml3401_xacro_hides_function{
    .id = "SML3401",
    .name = "xacro-hides-function",
    .severity = Severity::warning,
    .summary = "A property or parameter hides a function or a constant of expressions.",
    .why = "All later expressions see the property: `pi`, `e` and `range` are no "
           "longer what they were.",
    .remedy = "Give the property another name.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3401_xacro_hides_function_file
