// SPDX-License-Identifier: BSD-3-Clause
// Mistakes in a configuration, and in schemas that it names.
#include "base/findings/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml9001_unknown_setting{
    .id = "SML9001",
    .name = "unknown-setting",
    .severity = Severity::error,
    .summary = "The configuration has an unknown key.",
    .why = "The key has no effect.",
    .remedy = "Write the suggested key, or delete it.",
    .sources = "smurf-lint."};

extern constinit const Rule sml9002_wrong_setting{
    .id = "SML9002",
    .name = "wrong-setting",
    .severity = Severity::error,
    .summary = "A setting of the configuration has an invalid value.",
    .why =
        "The value is ignored: a rule that does not exist selects nothing, and a schema that cannot be read checks nothing.",
    .remedy = "Write a value of this kind; `--list-rules` shows the rules.",
    .sources = "smurf-lint."};

extern constinit const Rule sml9011_broken_schema{
    .id = "SML9011",
    .name = "broken-schema",
    .severity = Severity::error,
    .summary = "A schema of your own cannot be used.",
    .why =
        "It is not a JSON Schema (draft-07), or applying it could take forever. It is not used for checks.",
    .remedy = "Correct the schema at this place. References lead to "
              "`#/definitions/NAME` of the same file.",
    .sources = "JSON Schema draft-07; limits of these tools."};

}  // namespace smurf::rules
