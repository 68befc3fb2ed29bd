// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || !joint.limit->velocity || *joint.limit->velocity >= 0) return;
    findings.report(joint.limit->velocity.span, "the velocity limit of " + title(joint) + " is " +
                                                    format_number(*joint.limit->velocity));
  });
}

}  // namespace

extern constinit const Rule sml1417_velocity_negative{
    .id = "SML1417",
    .name = "velocity-negative",
    .severity = Severity::error,
    .summary = "The velocity limit of a joint is negative.",
    .why = "Drake aborts the process, MoveIt takes the absolute value.",
    .remedy = "Write a positive number.",
    .sources = "Drake joint.h:160; MoveIt robot_model.cpp:874.",
    .check_model = check};

}  // namespace smurf::rules
