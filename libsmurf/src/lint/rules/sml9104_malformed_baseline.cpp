// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml9104_malformed_baseline_file {

extern constinit const Rule sml9104_malformed_baseline{
    .id = "SML9104",
    .name = "malformed-baseline",
    .severity = Severity::error,
    .summary = "A baseline file does not have the form that smurf-lint writes.",
    .why = "Entries that smurf-lint cannot read suppress no finding.",
    .remedy = "Write it again with `smurf-lint --generate-baseline`.",
    .sources = "smurf-lint"};

}  // namespace smurf::rules::sml9104_malformed_baseline_file
