// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.has_one_axis() || joint.mimic || !joint.limit || !joint.limit->velocity) return;
    if (*joint.limit->velocity != 0 || has_equal_bounds(joint)) return;
    // Effort and velocity both zero is one placeholder, reported as the effort.
    if (joint.limit->effort.value_or(1) == 0) return;
    findings.report(joint.limit->velocity.span, "the velocity limit of " + title(joint) + " is 0")
        .notes.push_back(
            "MoveIt and Isaac read no limit, Drake and Bullet a joint that cannot move");
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "keeps the joint from moving", "Bullet, read"},
    {&readers::ros, Effect::changes, "treats 0 as no limit (MoveIt)", "MoveIt robot_model.cpp:874"},
    {&readers::drake, Effect::changes, "keeps the joint from moving",
     "Drake detail_urdf_parser.cc"},
};

}  // namespace

extern constinit const Rule sml1416_velocity_zero{
    .id = "SML1416",
    .name = "velocity-zero",
    .severity = Severity::warning,
    .summary = "The velocity limit of a movable joint is 0.",
    .why = "Isaac treats 0 as no limit.",
    .remedy = "Write the speed that the drive reaches.",
    .sources = "Isaac UrdfImporter.cpp:964.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
