// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3403_xacro_lost_attribute_file {

extern constinit const Rule sml3403_xacro_lost_attribute{
    .id = "SML3403",
    .name = "xacro-lost-attribute",
    .severity = Severity::error,
    .summary = "`xacro:attribute` sets an attribute of an element that is not in the "
               "result.",
    .why = "Inside of `xacro:if`, a macro or an included file, the attribute is lost "
           "without a message.",
    .remedy = "Put `xacro:attribute` directly into the element that gets the attribute.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3403_xacro_lost_attribute_file
