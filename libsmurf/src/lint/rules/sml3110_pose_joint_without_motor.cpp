// SPDX-License-Identifier: BSD-3-Clause

#include <map>

#include "base/findings/readers.hpp"
#include "lint/model_answers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3110_pose_joint_without_motor_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  // A model without motors is not meant to move in MARS.
  if (!can_judge(model, NameKind::motor) || model.annotations.motors.empty()) return;
  std::map<std::string_view, const Motor*> by_joint;
  for (const Reference& one : findings.answers().doubtful_references()) {
    const bool is_joint = one.is_known() && one.kind == NameKind::joint;
    if (!is_joint || annotation_place(model, one).section != "poses") continue;
    if (by_joint.empty()) {
      for (const Motor& motor : model.annotations.motors) {
        if (motor.joint && motor.name) by_joint.emplace(*motor.joint, &motor);
      }
    }
    Diagnostic& diagnostic =
        findings.report(place_of(one), "MARS does not move the joint " + quoted(one.name) +
                                           ": there is no motor of this name");
    const auto found = by_joint.find(one.name);
    if (found == by_joint.end()) continue;
    diagnostic.label(found->second->name.span, "the motor of this joint");
    diagnostic.help("name the motor " + quoted(one.name) + ", like its joint");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "looks the names up among the motors: the joint is not moved",
     "MARS SimEntity.cpp:505-511"},
    {&readers::phobos, Effect::takes, "looks the names up among the joints", "Phobos io/poses.py"},
};

}  // namespace

extern constinit const Rule sml3110_pose_joint_without_motor{
    .id = "SML3110",
    .name = "pose-joint-without-motor",
    .severity = Severity::warning,
    .summary = "A joint pose names a joint that has no motor of the same name.",
    .remedy = "Give the motor the name of its joint, which all readers understand.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3110_pose_joint_without_motor_file
