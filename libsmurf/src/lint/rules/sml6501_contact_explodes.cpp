// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6501_contact_explodes_file {

extern constinit const Rule sml6501_contact_explodes{
    .id = "SML6501",
    .name = "contact-explodes",
    .severity = Severity::error,
    .summary = "A robot that is dropped from a height of 1 mm is flung away.",
    .why =
        "Shapes inside each other, or contacts on bodies that are far too light, push the robot away with extreme forces.",
    .remedy = "Shrink the shapes that overlap, or give them bitmasks that share no bit.",
    .sources = "ODE 0.16.2, executed: sound robots gain at most 0.07 m, exploding ones 1e4 m.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6501_contact_explodes_file
