// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.has_one_axis() || joint.mimic || !joint.limit || !joint.limit->effort) return;
    if (*joint.limit->effort != 0 || has_equal_bounds(joint)) return;
    findings.report(joint.limit->effort.span, "the effort limit of " + title(joint) + " is 0")
        .notes.push_back("MuJoCo reads no limit, Gazebo and Bullet no force at all");
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "gives the joint no force", kRun},
    {&readers::gazebo, Effect::changes, "gives the joint no force", kRun},
    {&readers::mujoco, Effect::changes, "makes the force unlimited", kRun},
    {&readers::drake, Effect::loses, "leaves the actuator of the joint out",
     "Drake detail_urdf_parser.cc:930-1001"},
};

}  // namespace

extern constinit const Rule sml1414_effort_zero{
    .id = "SML1414",
    .name = "effort-zero",
    .severity = Severity::warning,
    .summary = "The effort limit of a movable joint is 0.",
    .remedy = "Write the effort that the drive can provide.",
    .sources = "88 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
