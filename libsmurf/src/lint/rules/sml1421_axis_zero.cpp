// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/findings/readers.hpp"
#include "base/numbers/exact_math.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1421_axis_zero_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kShortest = 1e-8;  // sdformat and Drake compare with about this
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.axis || !joint.is_movable()) return;
    const Vector3& axis = *joint.axis;
    if (hypotenuse(axis[0], axis[1], axis[2]) >= kShortest) return;
    findings.report(joint.axis.span,
                    "the axis of " + title(joint) + " is zero, so it has no direction");
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes, "accepts it: the joint has no direction", kRun},
    {&readers::pybullet, Effect::changes, "accepts it: the joint has no direction",
     "Bullet UrdfParser.cpp, run"},
    {&readers::gazebo, Effect::refuses, "reports error E9, an axis of length 0", kRun},
    {&readers::mujoco, Effect::refuses, "refuses an axis of length 0", kRun},
    {&readers::drake, Effect::refuses, "refuses an axis of length 0", kRun},
    {&readers::phobos, Effect::changes, "accepts it: the joint has no direction", kRun},
};

}  // namespace

extern constinit const Rule sml1421_axis_zero{
    .id = "SML1421",
    .name = "axis-zero",
    .severity = Severity::error,
    .summary = "The axis of a joint is the zero vector.",
    .remedy = "Write the direction the joint turns about or moves along.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1421_axis_zero_file
