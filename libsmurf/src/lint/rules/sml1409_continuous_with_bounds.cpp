// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1409_continuous_with_bounds_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.type != urdf::JointType::continuous || !joint.limit) return;
    const Field<double>& lower = joint.limit->lower;
    const Field<double>& upper = joint.limit->upper;
    if (lower.value_or(0) == 0 && upper.value_or(0) == 0) return;  // written as zero by exporters
    findings
        .report(lower.written ? lower.span : upper.span,
                title(joint) + " is continuous, but has position limits")
        .note("MuJoCo, Drake and Isaac enforce them, the others ignore them");
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::ignores, "keeps the limits, and its users ignore them", kRun},
    {&readers::pybullet, Effect::ignores, "ignores the limits", "URDF2Bullet.cpp:541"},
    {&readers::mujoco, Effect::changes, "enforces the limits", kRun, before({4, 0})},
    {&readers::mujoco, Effect::ignores, "ignores the limits", "4.0.0, run"},
    {&readers::drake, Effect::changes, "enforces the limits",
     "Drake detail_urdf_parser.cc:628-643"},
    {&readers::pinocchio, Effect::ignores, "ignores the limits", kRun},
};

}  // namespace

extern constinit const Rule sml1409_continuous_with_bounds{
    .id = "SML1409",
    .name = "continuous-with-bounds",
    .severity = Severity::warning,
    .summary = "A continuous joint has position limits.",
    .why = "Isaac enforces them.",
    .remedy = "Make the joint revolute, or delete the limits.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1409_continuous_with_bounds_file
