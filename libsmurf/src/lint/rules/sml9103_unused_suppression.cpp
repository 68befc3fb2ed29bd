// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml9103_unused_suppression{
    .id = "SML9103",
    .name = "unused-suppression",
    .severity = Severity::warning,
    .summary = "A comment for smurf-lint silences nothing.",
    .why =
        "The fault it was written for is mended, or the comment stands in the wrong place; if it "
        "stays, it will silence the next fault there.",
    .remedy = "Remove the comment; `--fix` does it.",
    .sources = "smurf-lint"};

}  // namespace smurf::rules
