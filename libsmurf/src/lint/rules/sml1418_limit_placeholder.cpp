// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1418_limit_placeholder_file {
namespace {

/// One finding per file, because exporters write the same limits into all joints.
void check(const LinkedModel& model, Findings& findings) {
  constexpr double kEffort = 1e4;    // N m or N
  constexpr double kVelocity = 1e3;  // rad/s or m/s
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.has_one_axis() || !joint.limit) return;
    const bool is_effort = joint.limit->effort.value_or(0) >= kEffort;
    if (!is_effort && joint.limit->velocity.value_or(0) < kVelocity) return;
    const Field<double>& limit = is_effort ? joint.limit->effort : joint.limit->velocity;
    findings.report_habit(limit.span,
                          std::string("the ") + (is_effort ? "effort" : "velocity") + " limit of " +
                              title(joint) + " looks like a placeholder: " + format_number(*limit),
                          "such limits");
  });
}

}  // namespace

extern constinit const Rule sml1418_limit_placeholder{
    .id = "SML1418",
    .name = "limit-placeholder",
    .severity = Severity::info,
    .summary = "An effort or velocity limit is a placeholder, not a property of the drive.",
    .why = "Planners, controllers and simulators use the number: trajectories are too fast for the "
           "robot, simulated joints pull with hundreds of kilonewtons.",
    .remedy = "Write the limits of the drive.",
    .sources =
        "Distribution of the limits of 322 files of the Tola/Corke dataset: 27 have such efforts, "
        "31 such velocities.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1418_limit_placeholder_file
