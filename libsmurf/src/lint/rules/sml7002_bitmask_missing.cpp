// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml7002_bitmask_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const CollisionAnnotation& entry : model.annotations.collisions) {
    if (entry.bitmask.written) continue;
    findings.report(entry.name.written ? entry.name.span : entry.span,
                    subject("collision entry", entry) + " has no `bitmask`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "reads 65535, which collides with everything",
     "MARS NodeData.cpp"},
    {&readers::mars2, Effect::takes, "reads 65535, which collides with everything",
     "MARS NodeData.cpp"},
    {&readers::envire, Effect::changes, "reads 0: the shape collides with nothing",
     "rock-cpp/smurf Robot.cpp:73"},
};

}  // namespace

extern constinit const Rule sml7002_bitmask_missing{.id = "SML7002",
                                                    .name = "bitmask-missing",
                                                    .severity = Severity::warning,
                                                    .summary = "A collision entry has no bitmask.",
                                                    .remedy = "Write `bitmask: 65535`.",
                                                    .check_model = check,
                                                    .needs_target = true,
                                                    .facts = kFacts};

}  // namespace smurf::rules::sml7002_bitmask_missing_file
