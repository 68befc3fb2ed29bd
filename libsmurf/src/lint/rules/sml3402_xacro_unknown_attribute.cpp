// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3402_xacro_unknown_attribute_file {

extern constinit const Rule sml3402_xacro_unknown_attribute{
    .id = "SML3402",
    .name = "xacro-unknown-attribute",
    .severity = Severity::warning,
    .summary = "An element of xacro has an attribute that xacro ignores.",
    .why = "A misspelt `value` makes an empty block instead of a property.",
    .remedy = "Correct the name of the attribute, or delete it.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3402_xacro_unknown_attribute_file
