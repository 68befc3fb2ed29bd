// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml9001_unknown_setting_file {

extern constinit const Rule sml9001_unknown_setting{
    .id = "SML9001",
    .name = "unknown-setting",
    .severity = Severity::error,
    .summary = "The configuration has an unknown key.",
    .why = "The key has no effect.",
    .remedy = "Write the suggested key, or delete it.",
    .sources = "smurf-lint."};

}  // namespace smurf::rules::sml9001_unknown_setting_file
