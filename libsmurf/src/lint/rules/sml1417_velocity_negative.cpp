// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "base/readers.hpp"
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

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps the number", kRun},
    {&readers::ros, Effect::changes, "MoveIt uses the absolute value",
     "MoveIt robot_model.cpp:874"},
    {&readers::mujoco, Effect::takes, "has no velocity limits", kRun},
    {&readers::drake, Effect::refuses, "throws an exception", "Drake joint.h:435"},
};

}  // namespace

extern constinit const Rule sml1417_velocity_negative{
    .id = "SML1417",
    .name = "velocity-negative",
    .severity = Severity::error,
    .summary = "The velocity limit of a joint is negative.",
    .remedy = "Write a positive number.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
