// SPDX-License-Identifier: BSD-3-Clause

#include <map>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3202_several_motors_on_joint_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  std::map<std::string_view, const Motor*> first;
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.joint) continue;
    const auto [found, is_new] = first.emplace(*motor.joint, &motor);
    const Motor& other = *found->second;
    if (is_new || (motor.name && other.name && *motor.name == *other.name)) continue;
    Diagnostic& diagnostic =
        findings.report(motor.joint.span, "the joint " + quoted(*motor.joint) + " is driven by " +
                                              subject("motor", other) + " as well");
    diagnostic.label(other.joint.span, "driven here");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "sets the velocity and force limit of the joint from each motor in every step, so only the "
     "last one has an effect",
     "MARS SimMotor.cpp:352-444"},
};

}  // namespace

extern constinit const Rule sml3202_several_motors_on_joint{
    .id = "SML3202",
    .name = "several-motors-on-joint",
    .severity = Severity::warning,
    .summary = "Two motors drive one joint.",
    .remedy = "Drive each joint by one motor.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml3202_several_motors_on_joint_file
