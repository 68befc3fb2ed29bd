// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check_bound(const urdf::Joint& joint, const Field<double>& soft, const Field<double>& hard,
                 bool is_lower, Findings& findings) {
  if (!soft || !hard || (is_lower ? *soft >= *hard : *soft <= *hard)) return;
  Diagnostic& diagnostic =
      findings.report(soft.span, "the soft limit " + format_number(*soft) + " of " + title(joint) +
                                     " lies beyond its hard limit " + format_number(*hard));
  diagnostic.labels.push_back({hard.span, "the hard limit"});
  diagnostic.fixes.push_back({Applicability::unsafe, {{soft.span, format_number(*hard)}}});
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool has_bounds =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (!has_bounds || !joint.limit || !joint.safety_controller) return;
    const urdf::SafetyController& safety = *joint.safety_controller;
    // Without both, MoveIt reads 0; that is reported.
    if (!safety.soft_lower_limit || !safety.soft_upper_limit) return;
    check_bound(joint, safety.soft_lower_limit, joint.limit->lower, true, findings);
    check_bound(joint, safety.soft_upper_limit, joint.limit->upper, false, findings);
  });
}

}  // namespace

extern constinit const Rule sml1430_soft_limits_outside_hard{
    .id = "SML1430",
    .name = "soft-limits-outside-hard",
    .severity = Severity::warning,
    .summary = "A soft limit lies beyond the hard limit of its joint.",
    .why = "A safety controller brakes before the hard limit is reached: beyond it, it never does.",
    .remedy = "Put the soft limits within the hard ones.",
    .sources = "PR2 safety limits on the ROS wiki; MoveIt robot_model.cpp:849-860.",
    .check_model = check};

}  // namespace smurf::rules
