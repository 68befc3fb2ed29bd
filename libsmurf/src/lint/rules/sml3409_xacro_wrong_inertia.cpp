// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml3409_xacro_wrong_inertia_file {

extern constinit const Rule sml3409_xacro_wrong_inertia{
    .id = "SML3409",
    .name = "xacro-wrong-inertia",
    .severity = Severity::warning,
    .summary = "The formulas of an inertia are nearly those of a box, a cylinder or a "
               "sphere.",
    .why = "A formula that was copied wrongly makes every link of the macro rotate "
           "wrongly, without a message.",
    .remedy = "Correct the formula. With mass m, a box has m/12 (y² + z²), m/12 "
              "(x² + z²) and m/12 (x² + y²); a cylinder along z m/12 "
              "(3 r² + h²) twice and m/2 r²; a sphere 2/5 m r².",
    .sources = "Formulas of solid bodies."};

}  // namespace smurf::rules::sml3409_xacro_wrong_inertia_file
