// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/findings/readers.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1422_axis_not_unit_file {
namespace {

constexpr Circumstance kPrismatic{"prismatic"};

void check(const LinkedModel& model, Findings& findings) {
  const double tolerance =
      findings.tolerance();  // an axis that is shorter by rounding to three digits is not a defect
  constexpr double kShortest = 1e-8;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.axis || !joint.has_one_axis()) return;
    Vector3 axis = *joint.axis;
    const double length = hypotenuse(axis[0], axis[1], axis[2]);
    if (length < kShortest || std::fabs(length - 1) <= tolerance) return;
    std::string unit;
    for (const double component : axis) {
      unit += (unit.empty() ? "" : " ") + format_number(component / length);
    }
    Diagnostic& diagnostic =
        findings.report(joint.axis.span, "the axis of " + title(joint) + " has the length " +
                                             format_rounded(length) + ", not 1");
    diagnostic.note("Bullet moves this joint " + format_rounded(length) +
                    " times as far as commanded");
    if (joint.type == urdf::JointType::prismatic) diagnostic.when(kPrismatic);
    diagnostic.help("write " + quoted(unit));
    diagnostic.fixes.push_back({Applicability::unsafe, {{joint.axis.span, unit}}});
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes,
     "does not normalise it: the joint moves too far or not far enough", kRun},
    {&readers::ros, Effect::changes, "MoveIt does not normalise the axis of a prismatic joint",
     "MoveIt robot_model.cpp", when(kPrismatic)},
};

}  // namespace

extern constinit const Rule sml1422_axis_not_unit{
    .id = "SML1422",
    .name = "axis-not-unit",
    .severity = Severity::warning,
    .summary = "The axis of a joint is not a unit vector.",
    .remedy = "Divide the axis by its length.",
    .check_model = check,
    .tolerance = {.value = 1e-3, .meaning = "how far the length of an axis may be from 1"},
    .facts = kFacts};

}  // namespace smurf::rules::sml1422_axis_not_unit_file
