// SPDX-License-Identifier: BSD-3-Clause
// Comments and baselines that do not do what they say.
#include "base/findings/rules.hpp"

namespace smurf::rules {

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

extern constinit const Rule sml9102_unknown_rule{
    .id = "SML9102",
    .name = "unknown-rule",
    .severity = Severity::warning,
    .summary = "A comment for smurf-lint names a rule that does not exist.",
    .why = "A misspelt rule silences nothing.",
    .remedy = "Name the rule as the report does: by its id or its name.",
    .sources = "smurf-lint --list-rules"};

extern constinit const Rule sml9103_unused_suppression{
    .id = "SML9103",
    .name = "unused-suppression",
    .severity = Severity::warning,
    .summary = "A comment for smurf-lint silences nothing.",
    .why = "The fault was repaired, or the comment is in the wrong place. If the comment stays, it "
           "hides the next finding there.",
    .remedy = "Remove the comment; `--fix` does it.",
    .sources = "smurf-lint"};

extern constinit const Rule sml9104_malformed_baseline{
    .id = "SML9104",
    .name = "malformed-baseline",
    .severity = Severity::error,
    .summary = "A baseline file does not have the form that smurf-lint writes.",
    .why = "Entries that smurf-lint cannot read suppress no finding.",
    .remedy = "Write it again with `smurf-lint --generate-baseline`.",
    .sources = "smurf-lint"};

extern constinit const Rule sml9105_stale_baseline_entry{
    .id = "SML9105",
    .name = "stale-baseline-entry",
    .severity = Severity::info,
    .summary = "A baseline suppresses a finding that no longer exists.",
    .why =
        "The fault was repaired. As long as the entry stays, the same fault can come back unnoticed.",
    .remedy = "Write the baseline again with `smurf-lint --generate-baseline`.",
    .sources = "smurf-lint"};

}  // namespace smurf::rules
