// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const CollisionAnnotation& entry : model.annotations.collisions) {
    if (entry.bitmask.written) continue;
    findings.report(entry.name.written ? entry.name.span : entry.span,
                    subject("collision entry", entry) + " has no `bitmask`");
  }
}

}  // namespace

extern constinit const Rule sml7002_bitmask_missing{
    .id = "SML7002",
    .name = "bitmask-missing",
    .severity = Severity::warning,
    .summary = "A collision entry has no bitmask.",
    .why = "MARS and MARS 2 read 65535 then, which collides with everything; MARS with envire "
           "reads 0, which collides with nothing.",
    .remedy = "Write `bitmask: 65535`.",
    .sources = "rock-cpp/smurf Robot.cpp:73; MARS NodeData.cpp.",
    .check_model = check,
    .needs_target = true};

}  // namespace smurf::rules
