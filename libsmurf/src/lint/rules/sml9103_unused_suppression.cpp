// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml9103_unused_suppression_file {

extern constinit const Rule sml9103_unused_suppression{
    .id = "SML9103",
    .name = "unused-suppression",
    .severity = Severity::warning,
    .summary = "A comment for smurf-lint silences nothing.",
    .why = "The fault was repaired, or the comment is in the wrong place. If the comment stays, it "
           "hides the next finding there.",
    .remedy = "Remove the comment; `--fix` does it.",
    .sources = "smurf-lint"};

}  // namespace smurf::rules::sml9103_unused_suppression_file
