// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/drake_queries.hpp"
#include "lint/model_answers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml1432_mimic_target_unknown_file {
namespace {

/// An empty name does not refer to anything.
void check_empty(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.mimic || !joint.mimic->joint || !joint.mimic->joint->empty()) return;
    check_reference(model, NameKind::joint, {}, joint.mimic->joint.span,
                    ("the mimic of " + title(joint)).c_str(), findings);
  });
}

void check(const LinkedModel& model, Findings& findings) {
  check_empty(model, findings);
  const auto drake_joints = drake::names_in(drake::own_joints(model), "name");
  for (const Reference& one : findings.answers().doubtful_references()) {
    const xml::View mimic = element_of(model, one);
    if (!mimic || mimic.name() != "mimic") continue;
    const std::string subject = "the mimic of " + subject_of(mimic.parent());
    const xml::Attribute* own = mimic.parent().attribute("name");
    Meanings meanings;
    if (own != nullptr) meanings.own = own->value();
    Diagnostic* diagnostic = check_reference(model, NameKind::joint, one.name, one.span,
                                             subject.c_str(), findings, meanings);
    if (diagnostic == nullptr || !drake_joints.contains(one.name)) continue;
    diagnostic->when(drake::kDrakeJoint);
    diagnostic->note(drake::kJointNote);
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes,
     "does not look for the leading joint, so the joint moves freely", kRun},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
    {&readers::pybullet, Effect::ignores, "ignores mimic", kRun},
    {&readers::mujoco, Effect::changes, "leaves the joint free", kRun},
    {&readers::drake, Effect::takes, "knows the joint", kRun, when(drake::kDrakeJoint)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1432_mimic_target_unknown{
    .id = "SML1432",
    .name = "mimic-target-unknown",
    .severity = Severity::error,
    .summary = "A joint mimics a joint that the robot does not have.",
    .why = "urdf-loader crashes.",
    .remedy = "Correct the name.",
    .sources = "urdf-loader 0.13, executed.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1432_mimic_target_unknown_file
