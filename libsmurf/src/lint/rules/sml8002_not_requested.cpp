// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml8002_not_requested{
    .id = "SML8002",
    .name = "not-requested",
    .severity = Severity::info,
    .summary = "An annotation differs from the URDF, and the export keeps the value of the URDF.",
    .why =
        "MARS simulates with the annotation; programs that read the exported URDF use the other value, and the same robot behaves differently.",
    .remedy = "Export with `--apply`, which uses the values of the annotations.",
    .sources = "MARS smurf.cpp:902 (limits of the URDF are not used), MaterialData.cpp:47-118.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
