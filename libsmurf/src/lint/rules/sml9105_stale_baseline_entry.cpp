// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml9105_stale_baseline_entry{
    .id = "SML9105",
    .name = "stale-baseline-entry",
    .severity = Severity::info,
    .summary = "A baseline lets a finding pass that is no longer there.",
    .why = "The fault is mended; as long as the entry stays, the same fault can come back unseen.",
    .remedy = "Write the baseline anew with `smurf-lint --generate-baseline`.",
    .sources = "smurf-lint"};

}  // namespace smurf::rules
