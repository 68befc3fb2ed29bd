// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3315_xacro_wrong_element_file {

extern constinit const Rule sml3315_xacro_wrong_element{
    .id = "SML3315",
    .name = "xacro-wrong-element",
    .severity = Severity::error,
    .summary = "An element of xacro lacks an attribute, or its attributes contradict "
               "each other.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Correct the attributes.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3315_xacro_wrong_element_file
