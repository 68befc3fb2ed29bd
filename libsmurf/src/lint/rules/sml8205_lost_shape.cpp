// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml8205_lost_shape_file {

extern constinit const Rule sml8205_lost_shape{
    .id = "SML8205",
    .name = "lost-shape",
    .severity = Severity::warning,
    .summary = "A shape cannot be written in the format.",
    .why = "The shape is missing in the result: nothing is drawn, and nothing collides.",
    .remedy = "Add the file, convert the mesh, or use a shape that the format has.",
    .sources = "smurfs-flatten.",
    .reported_by = Tool::converters};

}  // namespace smurf::rules::sml8205_lost_shape_file
