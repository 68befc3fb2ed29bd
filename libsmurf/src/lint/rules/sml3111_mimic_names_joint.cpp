// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/model_answers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml3111_mimic_names_joint_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!can_judge(model, NameKind::motor)) return;
  for (const Reference& one : findings.answers().doubtful_references()) {
    const bool is_joint = one.is_known() && one.kind == NameKind::joint;
    if (!is_joint || annotation_place(model, one).section != "motors") continue;
    Diagnostic& diagnostic =
        findings.report(place_of(one), "MARS finds no motor " + quoted(one.name) +
                                           ": only Phobos accepts the name of a joint here");
    diagnostic.label(definition(model, NameKind::joint, one.name), "the joint is defined here");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "looks for a motor of that name; when there is none, the motor adds its offset in every step "
     "and drifts away",
     "MARS MotorManager.cpp:537-544, SimMotor.cpp:356"},
    {&readers::phobos, Effect::takes, "writes and reads the name of the joint that is mimicked",
     "Phobos representation.py:2399"},
};

}  // namespace

extern constinit const Rule sml3111_mimic_names_joint{
    .id = "SML3111",
    .name = "mimic-names-joint",
    .severity = Severity::warning,
    .summary = "A motor mimics a joint, where MARS needs a motor.",
    .remedy = "Give the leading motor the name of its joint, which both understand.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3111_mimic_names_joint_file
