// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "base/numbers/numbers.hpp"
#include "lint/mimic_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1435_mimic_exceeds_limits_file {
namespace {

bool has_bounds(const urdf::Joint& joint) {
  const bool is_bounded =
      joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
  return is_bounded && joint.limit && joint.limit->lower && joint.limit->upper &&
         *joint.limit->lower < *joint.limit->upper;
}

void check(const LinkedModel& model, Findings& findings) {
  const double rounding = findings.tolerance();
  if (!model.robot) return;
  for (std::uint32_t i = 0; i < model.robot->joints.size(); ++i) {
    const urdf::Joint& joint = model.robot->joints[i];
    const auto index = mimic_leader(model, i);
    if (!index || *index == i || !has_bounds(joint)) continue;
    const urdf::Joint& leader = model.robot->joints[*index];
    if (!has_bounds(leader)) continue;
    const double factor = joint.mimic->multiplier.value_or(1);
    const double offset = joint.mimic->offset.value_or(0);
    double low = factor * *leader.limit->lower + offset;
    double high = factor * *leader.limit->upper + offset;
    if (low > high) std::swap(low, high);
    const double lower = *joint.limit->lower;
    const double upper = *joint.limit->upper;
    const double slack = rounding * (upper - lower);
    if (low >= lower - slack && high <= upper + slack) continue;
    Diagnostic& diagnostic = findings.report(
        tag_name(model, joint.mimic->element),
        title(joint) + " follows " + title(leader) + " from " + format_rounded(low, 4) + " to " +
            format_rounded(high, 4) + ", but its limits are " + format_rounded(lower, 4) + " and " +
            format_rounded(upper, 4));
    diagnostic.label(tag_name(model, joint.limit->element), "the limits");
    diagnostic.label(tag_name(model, leader.limit->element), "the limits of the leading joint");
  }
}

}  // namespace

extern constinit const Rule sml1435_mimic_exceeds_limits{
    .id = "SML1435",
    .name = "mimic-exceeds-limits",
    .severity = Severity::warning,
    .summary = "A mimic joint would have to exceed its limits.",
    .why = "The constraint fights the limit: simulators jitter or stop the leading joint, and "
           "planners find no path.",
    .remedy = "Widen the limits of the mimic joint, or narrow those of the joint it follows.",
    .sources = "MuJoCo, executed; 9 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .tolerance =
        {.value = 0.01,
         .meaning = "how far the joint may be moved beyond its limits, as a fraction of its range"},
    .about = About::robot};

}  // namespace smurf::rules::sml1435_mimic_exceeds_limits_file
