// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml8005_collapsed_link{
    .id = "SML8005",
    .name = "collapsed-link",
    .severity = Severity::info,
    .summary = "A link on a fixed joint becomes part of the link that carries it.",
    .why = "Masses, shapes and sensors stay where they are, but the frame is gone: programs that "
           "ask for it by name, as tf2 does, find none.",
    .remedy = "Export with `--keep`, which takes names of links and joints.",
    .sources = "sdformat and MuJoCo do the same on their own: ReduceFixedJoints, "
               "fusestatic.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules
