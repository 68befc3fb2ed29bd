// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kShortest = 1e-8;  // sdformat and Drake compare with about this
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.axis || !joint.is_movable()) return;
    const Vector3& axis = *joint.axis;
    if (std::hypot(axis[0], axis[1], axis[2]) >= kShortest) return;
    findings.report(joint.axis.span, "the axis of " + title(joint) + " has no direction");
  });
}

}  // namespace

extern constinit const Rule sml1421_axis_zero{
    .id = "SML1421",
    .name = "axis-zero",
    .severity = Severity::error,
    .summary = "The axis of a joint is the zero vector.",
    .why = "Drake and MuJoCo refuse the file, sdformat reports an error; urdfdom accepts it and "
           "the joint has no direction.",
    .remedy = "Write the direction the joint turns about or moves along.",
    .sources = "sdformat 12.3 and MuJoCo 3.14, executed.",
    .check_model = check};

}  // namespace smurf::rules
