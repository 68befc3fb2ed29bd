// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6201_initial_overlap_file {

extern constinit const Rule sml6201_initial_overlap{
    .id = "SML6201",
    .name = "initial-overlap",
    .severity = Severity::warning,
    .summary = "Two collision shapes overlap at the start.",
    .why = "ODE pushes them apart in the first steps, with a force that has no limit; only bodies "
           "that a joint connects are left alone.",
    .remedy = "Shrink one shape, or give the two bitmasks that share no bit.",
    .sources = "15 of 307 robots; Panda 36 mm, Baxter 67 mm.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6201_initial_overlap_file
