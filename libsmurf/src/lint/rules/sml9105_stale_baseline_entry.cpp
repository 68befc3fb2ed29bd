// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml9105_stale_baseline_entry_file {

extern constinit const Rule sml9105_stale_baseline_entry{
    .id = "SML9105",
    .name = "stale-baseline-entry",
    .severity = Severity::info,
    .summary = "A baseline suppresses a finding that no longer exists.",
    .why =
        "The fault was repaired. As long as the entry stays, the same fault can come back unnoticed.",
    .remedy = "Write the baseline again with `smurf-lint --generate-baseline`.",
    .sources = "smurf-lint"};

}  // namespace smurf::rules::sml9105_stale_baseline_entry_file
