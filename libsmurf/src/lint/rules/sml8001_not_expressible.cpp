// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml8001_not_expressible{
    .id = "SML8001",
    .name = "not-expressible",
    .severity = Severity::info,
    .summary = "An annotation has no counterpart in a URDF.",
    .why = "A program that reads the exported URDF does not know of it: gains of motors, sensors, "
           "bitmasks, joint pose sets and the like.",
    .remedy = "Hand it over in another way, or use a reader of SMURF.",
    .sources = "The elements of URDF: urdfdom 3 and 5.1.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
