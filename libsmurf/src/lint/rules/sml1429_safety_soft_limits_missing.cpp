// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1429_safety_soft_limits_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.safety_controller || !joint.has_one_axis()) return;
    const urdf::SafetyController& safety = *joint.safety_controller;
    if (joint.type == urdf::JointType::continuous) return;
    if (safety.soft_lower_limit.written && safety.soft_upper_limit.written) return;
    // Without gain it is refused before anybody looks at its limits (SML1113).
    if (!safety.k_velocity.written) return;
    const bool is_misspelt = (!safety.soft_lower_limit.written &&
                              is_slip(model, safety.element, "soft_lower_limit", findings)) ||
                             (!safety.soft_upper_limit.written &&
                              is_slip(model, safety.element, "soft_upper_limit", findings));
    if (is_misspelt) return;
    findings
        .report(tag_name(model, safety.element),
                "the safety controller of " + title(joint) + " lacks a soft limit")
        .note("MoveIt reads the absent limit as 0");
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::changes, "MoveIt reads the absent limits as 0 and freezes the joint",
     "MoveIt robot_model.cpp:849-860"},
};

}  // namespace

extern constinit const Rule sml1429_safety_soft_limits_missing{
    .id = "SML1429",
    .name = "safety-soft-limits-missing",
    .severity = Severity::warning,
    .summary = "A safety controller has no soft limits.",
    .remedy = "Write soft_lower_limit and soft_upper_limit.",
    .check_model = check,
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1429_safety_soft_limits_missing_file
