// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool has_bounds =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (!has_bounds || !joint.limit || !joint.limit->lower || !joint.limit->upper) return;
    if (*joint.limit->lower != *joint.limit->upper) return;
    findings
        .report(joint.limit->upper.span,
                "the limits of " + title(joint) + " are equal, so it cannot move")
        .notes.push_back("MuJoCo ignores such limits: the joint is free there");
  });
}

}  // namespace

extern constinit const Rule sml1408_bounds_equal{
    .id = "SML1408",
    .name = "bounds-equal",
    .severity = Severity::warning,
    .summary = "The two position limits of a joint are equal.",
    .why = "sdformat, Drake and Bullet lock the joint, MuJoCo lets it turn freely.",
    .remedy = "Make the joint fixed, or correct the limits.",
    .sources = "MuJoCo 3.14, sdformat 12.3 and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
