// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1409_continuous_with_bounds_file {
namespace {

constexpr Circumstance kReversed{"lower above upper"};

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.type != urdf::JointType::continuous || !joint.limit) return;
    const Field<double>& lower = joint.limit->lower;
    const Field<double>& upper = joint.limit->upper;
    if (lower.value_or(0) == 0 && upper.value_or(0) == 0) return;  // written as zero by exporters
    Diagnostic& diagnostic =
        findings
            .report(lower.written ? lower.span : upper.span,
                    title(joint) + " is continuous, but has position limits")
            .note("MuJoCo, Drake and Newton apply them, the others ignore them");
    if (lower.value_or(0) > upper.value_or(0)) diagnostic.when(kReversed);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::ignores, "keeps the limits, and its users ignore them", kRun},
    {&readers::pybullet, Effect::ignores, "ignores the limits", kRun},
    {&readers::mujoco, Effect::changes, "enforces the limits", kRun, before({4, 0})},
    {&readers::mujoco, Effect::ignores, "ignores the limits", "4.0.0, run"},
    {&readers::drake, Effect::crashes, "ends the process when the lower limit is above the upper",
     kRun, when(kReversed)},
    {&readers::drake, Effect::changes, "enforces the limits", kRun},
    {&readers::pinocchio, Effect::ignores, "ignores the limits", kRun},
};

}  // namespace

extern constinit const Rule sml1409_continuous_with_bounds{
    .id = "SML1409",
    .name = "continuous-with-bounds",
    .severity = Severity::warning,
    .summary = "A continuous joint has position limits.",
    .remedy = "Make the joint revolute, or delete the limits.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1409_continuous_with_bounds_file
