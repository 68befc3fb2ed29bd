// SPDX-License-Identifier: BSD-3-Clause
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
        .notes.push_back("MoveIt and Isaac read no limit, Drake and Bullet a joint that stands");
  });
}

}  // namespace

extern constinit const Rule sml1416_velocity_zero{
    .id = "SML1416",
    .name = "velocity-zero",
    .severity = Severity::warning,
    .summary = "The velocity limit of a movable joint is 0.",
    .why = "Drake and Bullet make the joint immobile, MoveIt and Isaac take 0 for no limit.",
    .remedy = "Write the speed that the drive reaches.",
    .sources = "MoveIt robot_model.cpp:874; Isaac UrdfImporter.cpp:964.",
    .check_model = check};

}  // namespace smurf::rules
