// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8003_ambiguous_file {

extern constinit const Rule sml8003_ambiguous{
    .id = "SML8003",
    .name = "ambiguous",
    .severity = Severity::info,
    .summary = "Several annotations give different values for the same part of the URDF.",
    .why = "Only one of them can be written. A simulator uses one of them, depending on its "
           "loading order.",
    .remedy = "Keep one of them.",
    .sources = "Two motors of one joint in MARS: smurf.cpp:257-270.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8003_ambiguous_file
