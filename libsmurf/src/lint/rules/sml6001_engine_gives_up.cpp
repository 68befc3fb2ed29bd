// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6001_engine_gives_up_file {
namespace {

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "runs ODE in its own process, and ends with it",
     "ODE 0.16.2, run"},
};

}  // namespace

extern constinit const Rule sml6001_engine_gives_up{
    .id = "SML6001",
    .name = "engine-gives-up",
    .severity = Severity::error,
    .summary = "ODE, or the reader of a mesh, stops or crashes on this model.",
    .remedy = "Look at the stage that the message names; --stages runs only that stage.",
    .sources = "ODE 0.16.2, executed: failed assertions, crossing open triangle meshes.",
    .facts = kFacts,
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6001_engine_gives_up_file
