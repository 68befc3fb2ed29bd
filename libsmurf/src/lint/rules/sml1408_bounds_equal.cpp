// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules::sml1408_bounds_equal_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!has_equal_bounds(joint)) return;
    const bool is_blank = *joint.limit->upper == 0 && joint.limit->effort.value_or(1) == 0;
    findings
        .report(joint.limit->upper.span,
                is_blank ? "the limit of " + title(joint) + " is all zeros, so it cannot move"
                         : "the limits of " + title(joint) + " are equal, so it cannot move")
        .note("MuJoCo ignores such limits: the joint is free there");
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "locks the joint", kRun},
    {&readers::gazebo, Effect::takes, "locks the joint", kRun},
    {&readers::mujoco, Effect::changes, "lets the joint move without limit", kRun},
    {&readers::drake, Effect::takes, "locks the joint", kRun},
};

}  // namespace

extern constinit const Rule sml1408_bounds_equal{
    .id = "SML1408",
    .name = "bounds-equal",
    .severity = Severity::warning,
    .summary = "The two position limits of a joint are equal.",
    .remedy = "Make the joint fixed, or correct the limits.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1408_bounds_equal_file
