// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3310_xacro_missing_file_file {

extern constinit const Rule sml3310_xacro_missing_file{
    .id = "SML3310",
    .name = "xacro-missing-file",
    .severity = Severity::error,
    .summary = "An included file or a YAML file cannot be read.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Correct the path. Relative paths belong to the file that is being "
              "processed.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

}  // namespace smurf::rules::sml3310_xacro_missing_file_file
