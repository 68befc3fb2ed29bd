// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool has_bounds =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (!has_bounds || !joint.limit || !joint.limit->lower || !joint.limit->upper) return;
    const Field<double>& lower = joint.limit->lower;
    const Field<double>& upper = joint.limit->upper;
    if (*lower >= *upper || (*lower <= 0 && *upper >= 0)) return;
    findings.report(*lower > 0 ? lower.span : upper.span,
                    title(joint) + " cannot be at 0, where robots start");
  });
}

}  // namespace

extern constinit const Rule sml1413_zero_outside_bounds{
    .id = "SML1413",
    .name = "zero-outside-bounds",
    .severity = Severity::info,
    .summary = "The position 0 lies outside the limits of a joint.",
    .why = "Simulators and RViz start with every joint at 0: the solver pushes the joint into its "
           "limits with the first step, MoveIt calls the start state invalid.",
    .remedy = "Start the robot in a position within the limits, e.g. in a joint pose of the model.",
    .sources = "MoveIt and PyBullet start states; 65 of 322 files of the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules
