// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
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
        .notes.push_back("MuJoCo, Drake and Isaac enforce them, the others ignore them");
  });
}

}  // namespace

extern constinit const Rule sml1409_continuous_with_bounds{
    .id = "SML1409",
    .name = "continuous-with-bounds",
    .severity = Severity::warning,
    .summary = "A continuous joint has position limits.",
    .why = "MuJoCo, Drake and Isaac enforce them; urdfdom users, sdformat, Bullet, Pinocchio and "
           "MoveIt ignore them.",
    .remedy = "Make the joint revolute, or delete the limits.",
    .sources = "MuJoCo 3.14 and sdformat 12.3, executed; Drake detail_urdf_parser.cc:628-643.",
    .check_model = check};

}  // namespace smurf::rules
