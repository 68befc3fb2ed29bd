// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml9001_unknown_setting{
    .id = "SML9001",
    .name = "unknown-setting",
    .severity = Severity::error,
    .summary = "The configuration has a key that is no setting.",
    .why = "It has no effect, and what was meant by it does not happen.",
    .remedy = "Write the key as suggested, or take it out.",
    .sources = "smurf-lint."};

}  // namespace smurf::rules
