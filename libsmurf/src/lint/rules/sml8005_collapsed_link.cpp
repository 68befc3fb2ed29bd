// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8005_collapsed_link_file {

extern constinit const Rule sml8005_collapsed_link{
    .id = "SML8005",
    .name = "collapsed-link",
    .severity = Severity::info,
    .summary = "A link on a fixed joint becomes part of the link that carries it.",
    .why = "Masses, shapes and sensors stay where they are, but the frame is gone: programs that "
           "look it up by name, such as tf2, do not find it.",
    .remedy = "Export with `--keep` and the name of the link or joint.",
    .sources = "sdformat and MuJoCo do the same on their own: ReduceFixedJoints, "
               "fusestatic.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8005_collapsed_link_file
