// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/suggest.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3203_motor_bounds_exceed_joint_file {
namespace {

void report(const Motor& motor, const urdf::Joint& joint, const Field<double>& bound,
            const Field<double>& limit, Findings& findings) {
  Diagnostic& diagnostic = findings.report(
      bound.span, subject("motor", motor) + " goes to " + format_rounded(*bound) +
                      " in MARS, but " + title(joint) + " only to " + format_rounded(*limit));
  diagnostic.label(limit.span, "the limit of the joint");
}

bool looks_like_degrees(double bound, const urdf::Joint& joint) {
  constexpr double kManyTurns = 4 * std::numbers::pi;
  return joint.type == urdf::JointType::revolute && std::fabs(bound) > kManyTurns;
}

/// One bound without the other: MARS uses half a turn, or 3.14 m, for the missing one.
void check_absent(const Motor& motor, const urdf::Joint& joint, const Field<double>& low,
                  const Field<double>& high, Findings& findings) {
  const bool is_low = high.written;
  const Field<double>& limit = is_low ? joint.limit->lower : joint.limit->upper;
  const double bound = is_low ? -std::numbers::pi : std::numbers::pi;
  if (is_low ? !is_clearly_less(bound, *limit) : !is_clearly_less(*limit, bound)) return;
  const Field<double>& given = is_low ? high : low;
  Diagnostic& diagnostic = findings.report(
      given.span, subject("motor", motor) + " has no " + (is_low ? "lower" : "upper") +
                      " bound and goes to " + format_rounded(bound) + " in MARS, but " +
                      title(joint) + " only to " + format_rounded(*limit));
  diagnostic.label(limit.span, "the limit of the joint");
}

/// Misspelt bounds are reported by their rule.
bool has_misspelt_bound(yaml::View mapping) {
  constexpr std::string_view kBounds[] = {"minValue", "maxValue", "minPosition", "maxPosition"};
  return mapping && std::any_of(mapping.begin(), mapping.end(), [&](yaml::View value) {
           return nearest(value.key(), kBounds).has_value();
         });
}

void check_motor(const LinkedModel& model, const Motor& motor, const urdf::Joint& joint,
                 Findings& findings) {
  if (!joint.limit || joint.type == urdf::JointType::continuous) return;
  const Field<double>& lower = joint.limit->lower;
  const Field<double>& upper = joint.limit->upper;
  // Equal limits are reported by SML1408.
  if (!lower || !upper || *lower >= *upper) return;
  const Field<double>& low = lower_bound(motor);
  const Field<double>& high = upper_bound(motor);
  if (low && high && *low > *high) return;  // reported
  if (low.written != high.written && !has_misspelt_bound(mapping_of(model, motor))) {
    check_absent(motor, joint, low, high, findings);
  }
  if (low && !looks_like_degrees(*low, joint) && is_clearly_less(*low, *lower)) {
    report(motor, joint, low, lower, findings);
  }
  if (high && !looks_like_degrees(*high, joint) && is_clearly_less(*upper, *high)) {
    report(motor, joint, high, upper, findings);
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor* leading : leading_motors(model)) {
    const Motor& motor = *leading;
    const urdf::Joint* joint = joint_of(model, motor);
    // Only position controllers are clamped.
    if (joint == nullptr || !joint->has_one_axis()) continue;
    if (control_in_mars(motor) != MotorControl::position) continue;
    check_motor(model, motor, *joint, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "ignores the limits of the URDF and clamps commands to the bounds of the motor only",
     "MARS smurf.cpp:902-910, SimMotor.cpp:352-365; MotorData.cpp"},
    {&readers::mars2, Effect::changes, "gives the joint no stops", "envire_smurf_loader, read"},
    {&readers::phobos, Effect::takes, "uses the limits of the joint", "Phobos a613e31, run"},
};

}  // namespace

extern constinit const Rule sml3203_motor_bounds_exceed_joint{
    .id = "SML3203",
    .name = "motor-bounds-exceed-joint",
    .severity = Severity::warning,
    .summary = "The bounds of a motor exceed the limits of its joint.",
    .why = "Readers of the URDF stop at the joint's limits.",
    .remedy = "Give the motor the bounds of its joint.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3203_motor_bounds_exceed_joint_file
