// SPDX-License-Identifier: BSD-3-Clause
#include "base/rules.hpp"

namespace smurf::rules {

extern constinit const Rule sml6001_engine_gives_up{
    .id = "SML6001",
    .name = "engine-gives-up",
    .severity = Severity::error,
    .summary = "ODE, or the reader of a mesh, stops or crashes on this model.",
    .why = "MARS runs the same engine in its own process and ends with it.",
    .remedy = "Look at the stage that the message names; --stages runs only that stage.",
    .sources = "ODE 0.16.2, executed: failed assertions, crossing open triangle meshes.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules
