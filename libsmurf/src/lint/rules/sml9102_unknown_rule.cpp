// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml9102_unknown_rule_file {

extern constinit const Rule sml9102_unknown_rule{
    .id = "SML9102",
    .name = "unknown-rule",
    .severity = Severity::warning,
    .summary = "A comment for smurf-lint names a rule that does not exist.",
    .why = "A misspelt rule silences nothing.",
    .remedy = "Name the rule as the report does: by its id or its name.",
    .sources = "smurf-lint --list-rules"};

}  // namespace smurf::rules::sml9102_unknown_rule_file
