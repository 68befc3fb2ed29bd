// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/rules.hpp"

namespace smurf::rules::sml6002_no_verdict_file {

extern constinit const Rule sml6002_no_verdict{
    .id = "SML6002",
    .name = "no-verdict",
    .severity = Severity::error,
    .summary =
        "The check of a model has no result: ODE's solver gave up, or it took too much time or "
        "memory.",
    .why = "Figures of a solver that gave up are meaningless, even where they look plausible. The "
           "time for a step of ODE grows with the third power of the number of connected bodies; a "
           "model that needs seconds here is not simulated in real time.",
    .remedy = "Look at the joint that the finding names, or start in another position with --pose. "
              "Simplify collision meshes, or allow more with --time-limit and --memory-limit.",
    .sources = "ODE 0.16.2, executed; the slowest of 307 robots takes 5 s, the median 23 ms.",
    .reported_by = Tool::load_check};

}  // namespace smurf::rules::sml6002_no_verdict_file
