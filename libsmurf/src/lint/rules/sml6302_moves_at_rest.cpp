// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6302_moves_at_rest_file {

extern constinit const Rule sml6302_moves_at_rest{
    .id = "SML6302",
    .name = "moves-at-rest",
    .severity = Severity::error,
    .summary = "A robot moves although no force acts on it.",
    .why = "Without gravity and contacts, a sound robot stays within 1e-15 m of its position; a "
           "robot that moves has joints that do not fit together.",
    .remedy = "Look at the origins of the joints above the link.",
    .sources = "ODE 0.16.2, executed: 132 of 132 sound robots move less than 5.1e-16 m.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6302_moves_at_rest_file
