// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules::sml1414_limit_zero_file {
namespace {

/// One finding for all efforts and one for all velocities: exporters write 0 at every joint.
void check(const LinkedModel& model, Findings& findings) {
  enum Habit { of_efforts, of_velocities };
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.has_one_axis() || joint.mimic || !joint.limit || has_equal_bounds(joint)) return;
    const Field<double>& effort = joint.limit->effort;
    const Field<double>& velocity = joint.limit->velocity;
    // Effort and velocity both zero is one placeholder.
    if (effort && *effort == 0) {
      findings
          .report_habit(effort.span, "the effort limit of " + title(joint) + " is 0", "such limits",
                        of_efforts)
          .note("in MuJoCo, 0 means no limit; in Gazebo and Bullet, no force");
    } else if (velocity && *velocity == 0) {
      findings
          .report_habit(velocity.span, "the velocity limit of " + title(joint) + " is 0",
                        "such limits", of_velocities)
          .note("in MoveIt, 0 means no limit; Drake and Bullet do not enforce it");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "gives the joint no force", kRun, at("@effort")},
    {&readers::pybullet, Effect::ignores, "does not enforce it", kRun, at("@velocity")},
    {&readers::ros, Effect::changes, "treats 0 as no limit (MoveIt)", "MoveIt robot_model.cpp:874",
     at("@velocity")},
    {&readers::gazebo, Effect::changes, "gives the joint no force", kRun, at("@effort")},
    {&readers::mujoco, Effect::changes, "makes the force unlimited", kRun, at("@effort")},
    {&readers::drake, Effect::loses, "leaves the actuator of the joint out", kRun, at("@effort")},
    {&readers::drake, Effect::ignores, "keeps the limit, and does not enforce it", kRun,
     at("@velocity")},
};

}  // namespace

extern constinit const Rule sml1414_limit_zero{
    .id = "SML1414",
    .name = "limit-zero",
    .severity = Severity::warning,
    .summary = "The effort or velocity limit of a movable joint is 0.",
    .remedy = "Write the effort that the drive can provide, and the speed that it reaches.",
    .sources = "88 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1414_limit_zero_file
