// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3405_xacro_message_file {

extern constinit const Rule sml3405_xacro_message{
    .id = "SML3405",
    .name = "xacro-message",
    .severity = Severity::warning,
    .summary = "The description reports a warning or an error with `xacro.warning()` or "
               "`xacro.error()`.",
    .why = "The author of the description wants to tell something.",
    .remedy = "Change the call or the arguments that the author of the description warns of.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3405_xacro_message_file
