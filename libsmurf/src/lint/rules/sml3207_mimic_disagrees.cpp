// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3207_mimic_disagrees_file {
namespace {

/// True when the leader of the motor drives the joint that the URDF names, or is that joint.
bool is_same_leader(const LinkedModel& model, const std::string& leader, const std::string& joint) {
  if (leader == joint) return true;
  const Motor* motor = model.find_motor(leader);
  if (motor == nullptr) return true;  // reported as unknown
  return !motor->joint || *motor->joint == joint;
}

void check_number(const Motor& motor, const Field<double>& of_motor, const Field<double>& of_joint,
                  double fallback, std::string_view key, Span mimic, Findings& findings) {
  if (!of_motor || (of_joint.written && !of_joint)) return;
  const double in_urdf = of_joint.value_or(fallback);
  if (!is_clearly_less(*of_motor, in_urdf) && !is_clearly_less(in_urdf, *of_motor)) return;
  Diagnostic& diagnostic =
      findings.report(of_motor.span, quoted(key) + " of " + subject("motor", motor) + " is " +
                                         format_rounded(*of_motor) + ", but " +
                                         format_rounded(in_urdf) + " in the URDF");
  diagnostic.label(of_joint.written ? of_joint.span : mimic, "in the URDF");
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Motor& motor : model.annotations.motors) {
    const urdf::Joint* joint = joint_of(model, motor);
    if (joint == nullptr || !joint->mimic) continue;
    const urdf::Mimic& mimic = *joint->mimic;
    const Span place = tag_name(model, mimic.element);
    if (!motor.mimic_motor.written) {
      Diagnostic& diagnostic = findings.report(
          motor.joint.span, subject("motor", motor) + " moves on its own in MARS, but " +
                                title(*joint) + " mimics another one in the URDF");
      diagnostic.label(place, "the mimic element");
      diagnostic.help("add `mimic_motor` and `mimic_multiplier`");
      continue;
    }
    if (!motor.mimic_motor || !mimic.joint) continue;
    if (motor.name && *motor.mimic_motor == *motor.name) continue;  // reported
    if (!is_same_leader(model, *motor.mimic_motor, *mimic.joint)) {
      Diagnostic& diagnostic = findings.report(
          motor.mimic_motor.span, subject("motor", motor) + " follows " +
                                      quoted(*motor.mimic_motor) + ", but " + title(*joint) +
                                      " follows " + quoted(*mimic.joint) + " in the URDF");
      diagnostic.label(mimic.joint.span, "in the URDF");
    }
    check_number(motor, motor.mimic_multiplier, mimic.multiplier, 1, "mimic_multiplier", place,
                 findings);
    check_number(motor, motor.mimic_offset, mimic.offset, 0, "mimic_offset", place, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "follows `mimic_motor` and ignores the mimic element of the URDF",
     "MARS smurf.cpp:902-910, MotorManager.cpp:104-109"},
};

}  // namespace

extern constinit const Rule sml3207_mimic_disagrees{
    .id = "SML3207",
    .name = "mimic-disagrees",
    .severity = Severity::warning,
    .summary = "A motor follows its leader differently than its joint does in the URDF.",
    .why = "Readers of the URDF follow the mimic element.",
    .remedy = "Make the two agree.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3207_mimic_disagrees_file
