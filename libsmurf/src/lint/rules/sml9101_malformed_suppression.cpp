// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml9101_malformed_suppression_file {

extern constinit const Rule sml9101_malformed_suppression{
    .id = "SML9101",
    .name = "malformed-suppression",
    .severity = Severity::warning,
    .summary = "smurf-lint does not understand a comment that addresses it.",
    .why = "The comment does not silence the finding it was written for.",
    .remedy =
        "Write `smurf-lint: ignore[SML3101] reason` at the end of the line or on the line above "
        "the entry, or `smurf-lint: ignore-file[SML3101] reason` for the whole file. The comment "
        "must name the rules.",
    .sources = "smurf-lint, docs/integrations.md"};

}  // namespace smurf::rules::sml9101_malformed_suppression_file
