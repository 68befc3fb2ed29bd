// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3309_xacro_unknown_package_file {

extern constinit const Rule sml3309_xacro_unknown_package{
    .id = "SML3309",
    .name = "xacro-unknown-package",
    .severity = Severity::error,
    .summary = "`$(find ...)` names a package that is not found.",
    .why = "xacro stops, so there is no robot.",
    .remedy = "Name its folder with `--package NAME=DIR`, or set ROS_PACKAGE_PATH.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true,
    .may_pass_elsewhere = true};

}  // namespace smurf::rules::sml3309_xacro_unknown_package_file
