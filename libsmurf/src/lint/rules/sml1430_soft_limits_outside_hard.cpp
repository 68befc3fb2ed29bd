// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1430_soft_limits_outside_hard_file {
namespace {

/// The message about wrong soft limits; empty when they are correct.
std::string fault_of(const urdf::Joint& joint, double soft_lower, double soft_upper) {
  const double lower = *joint.limit->lower;
  const double upper = *joint.limit->upper;
  const auto range = [](double from, double to) {
    return format_number(from) + " to " + format_number(to);
  };
  if (soft_lower > soft_upper) {
    return "the lower soft limit " + format_number(soft_lower) + " of " + title(joint) +
           " is above the upper one " + format_number(soft_upper);
  }
  if (soft_lower >= lower && soft_upper <= upper) return {};
  return "the soft limits of " + title(joint) + " reach from " + range(soft_lower, soft_upper) +
         ", beyond its hard limits " + range(lower, upper);
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool has_bounds =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (!has_bounds || !joint.limit || !joint.safety_controller) return;
    const Field<double>& lower = joint.limit->lower;
    const Field<double>& upper = joint.limit->upper;
    const Field<double>& soft_lower = joint.safety_controller->soft_lower_limit;
    const Field<double>& soft_upper = joint.safety_controller->soft_upper_limit;
    // Missing soft limits (SML1429) and wrong hard limits (SML1407) are reported by their rules.
    if (!soft_lower || !soft_upper || !lower || !upper || *lower >= *upper) return;
    std::string fault = fault_of(joint, *soft_lower, *soft_upper);
    if (fault.empty()) return;
    const bool is_lower = *soft_lower < *lower || *soft_lower > *soft_upper;
    Diagnostic& diagnostic =
        findings.report(is_lower ? soft_lower.span : soft_upper.span, std::move(fault));
    diagnostic.label(is_lower ? lower.span : upper.span, "the hard limit");
    if (*soft_lower > *soft_upper) return;
    const std::string new_lower = format_number(std::max(*soft_lower, *lower));
    const std::string new_upper = format_number(std::min(*soft_upper, *upper));
    diagnostic.help("write soft limits from " + new_lower + " to " + new_upper);
    diagnostic.fixes.push_back(
        {Applicability::unsafe, {{soft_lower.span, new_lower}, {soft_upper.span, new_upper}}});
  });
}

}  // namespace

extern constinit const Rule sml1430_soft_limits_outside_hard{
    .id = "SML1430",
    .name = "soft-limits-outside-hard",
    .severity = Severity::warning,
    .summary = "Soft limits lie beyond the hard limits of their joint, or are swapped.",
    .why =
        "A safety controller brakes before the hard limit is reached. With soft limits beyond the "
        "hard ones, it never brakes.",
    .remedy = "Put the soft limits within the hard ones.",
    .sources = "PR2 safety limits on the ROS wiki; MoveIt robot_model.cpp:849-860.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1430_soft_limits_outside_hard_file
