// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3319_xacro_undeclared_prefix_file {

extern constinit const Rule sml3319_xacro_undeclared_prefix{
    .id = "SML3319",
    .name = "xacro-undeclared-prefix",
    .severity = Severity::error,
    .summary = "The prefix `xacro` is used, but not declared.",
    .why = "xacro refuses the file.",
    .remedy = "Add `xmlns:xacro=\"http://www.ros.org/wiki/xacro\"` to the root element.",
    .sources = "xacro 2.1.1, run.",
    .blocks_building = true};

}  // namespace smurf::rules::sml3319_xacro_undeclared_prefix_file
