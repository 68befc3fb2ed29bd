// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8001_not_expressible_file {

extern constinit const Rule sml8001_not_expressible{
    .id = "SML8001",
    .name = "not-expressible",
    .severity = Severity::info,
    .summary = "An annotation has no counterpart in a URDF.",
    .why =
        "Programs that read the exported URDF do not get it. Examples are motor gains, sensors, bitmasks and joint pose sets.",
    .remedy = "Pass the values on in another way, or use a program that reads SMURF.",
    .sources = "The elements of URDF: urdfdom 3 and 5.1.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8001_not_expressible_file
