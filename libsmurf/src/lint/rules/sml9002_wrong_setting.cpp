// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml9002_wrong_setting_file {

extern constinit const Rule sml9002_wrong_setting{
    .id = "SML9002",
    .name = "wrong-setting",
    .severity = Severity::error,
    .summary = "A setting of the configuration has an invalid value.",
    .why =
        "The value is ignored: a rule that does not exist selects nothing, and a schema that cannot be read checks nothing.",
    .remedy = "Write a value of this kind; `--list-rules` shows the rules.",
    .sources = "smurf-lint."};

}  // namespace smurf::rules::sml9002_wrong_setting_file
