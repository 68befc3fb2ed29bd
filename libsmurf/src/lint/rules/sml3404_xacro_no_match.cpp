// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3404_xacro_no_match_file {

extern constinit const Rule sml3404_xacro_no_match{
    .id = "SML3404",
    .name = "xacro-no-match",
    .severity = Severity::warning,
    .summary = "An include with `*`, `?` or `[` matches no file.",
    .why = "Nothing is included.",
    .remedy = "Correct the pattern.",
    .sources = "xacro 2.1.1, run."};

}  // namespace smurf::rules::sml3404_xacro_no_match_file
