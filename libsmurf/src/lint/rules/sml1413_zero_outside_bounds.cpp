// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1413_zero_outside_bounds_file {
namespace {

/// Whether DART, which starts in the middle of limits without 0, cannot compute with that position.
bool overflows_at_start(const urdf::Joint& joint) {
  const double lower = joint.limit->lower.value_or(0);
  const double upper = joint.limit->upper.value_or(0);
  if (lower <= 0 && upper >= 0) return false;
  const double middle = (lower + upper) / 2;
  return !std::isfinite(joint.type == urdf::JointType::prismatic ? middle : middle * middle);
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || !joint.has_one_axis()) return;
    const Field<double>& lower = joint.limit->lower;
    const Field<double>& upper = joint.limit->upper;
    if (overflows_at_start(joint)) {
      const bool is_lower = std::abs(lower.value_or(0)) > std::abs(upper.value_or(0));
      findings
          .report((is_lower ? lower : upper).span,
                  title(joint) + " cannot be at 0, and the middle of its limits is too far away "
                                 "for computations")
          .when(cases::kOverflow);
      return;
    }
    if (joint.type == urdf::JointType::continuous || !lower || !upper) return;
    if (*lower >= *upper || (*lower <= 0 && *upper >= 0)) return;
    findings.report(*lower > 0 ? lower.span : upper.span,
                    title(joint) + " cannot be at 0, where robots start");
  });
}

constexpr Fact kFacts[] = {
    {&readers::dart, Effect::crashes,
     "starts in the middle of the limits, and ends the process with an assertion", kRun,
     when(cases::kOverflow).before({6, 20})},
};

}  // namespace

extern constinit const Rule sml1413_zero_outside_bounds{
    .id = "SML1413",
    .name = "zero-outside-bounds",
    .severity = Severity::info,
    .summary = "The position 0 lies outside the limits of a joint.",
    .why = "Simulators and RViz start with every joint at 0: the solver pushes the joint into its "
           "limits with the first step, motion planners call the start state invalid.",
    .remedy =
        "Start the robot in a position within the limits, e.g. in a joint pose of the model, or "
        "with `initial_value` of ros2_control.",
    .sources = "MoveIt and PyBullet start states; 65 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1413_zero_outside_bounds_file
