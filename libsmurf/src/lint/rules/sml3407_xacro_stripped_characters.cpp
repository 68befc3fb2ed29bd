// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3407_xacro_stripped_characters_file {

extern constinit const Rule sml3407_xacro_stripped_characters{
    .id = "SML3407",
    .name = "xacro-stripped-characters",
    .severity = Severity::warning,
    .summary = "`strip()`, `lstrip()` or `rstrip()` is called with a word, and removes its "
               "characters.",
    .why = "`'tool_link'.rstrip('_link')` is `'too'`: characters are removed from the "
           "end as long as they occur in the word, in any order.",
    .remedy = "Write `removesuffix()` or `removeprefix()`.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3407_xacro_stripped_characters_file
