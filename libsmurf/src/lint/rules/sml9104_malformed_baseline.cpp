// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml9104_malformed_baseline{
    .id = "SML9104",
    .name = "malformed-baseline",
    .severity = Severity::error,
    .summary = "A baseline file is not one that smurf-lint has written.",
    .why = "What cannot be understood lets no finding pass, and what was meant is not known.",
    .remedy = "Write it anew with `smurf-lint --generate-baseline`.",
    .sources = "smurf-lint"};

}  // namespace smurf::rules
