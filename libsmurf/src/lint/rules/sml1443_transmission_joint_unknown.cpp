// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/drake_queries.hpp"
#include "lint/model_answers.hpp"
#include "lint/reference_queries.hpp"

namespace smurf::rules::sml1443_transmission_joint_unknown_file {
namespace {

/// Drake reads transmissions of one type only.
constexpr Circumstance kNotSimple{"not a SimpleTransmission"};

void check(const LinkedModel& model, Findings& findings) {
  const auto drake_joints = drake::names_in(drake::own_joints(model), "name");
  for (const Reference& one : findings.answers().doubtful_references()) {
    const xml::View joint = element_of(model, one);
    if (!joint || joint.name() != "joint" || joint.parent().name() != "transmission") continue;
    // `{name}_hip` lacks a dollar: SML3408 says so in a xacro, once for all names.
    const bool lacks_dollar =
        model.language == Language::xacro && one.name.find('{') != one.name.npos;
    if (lacks_dollar) continue;
    Diagnostic* diagnostic =
        check_reference(model, NameKind::joint, one.name, one.span, "a transmission", findings);
    if (diagnostic == nullptr) continue;
    if (!drake::is_simple(joint.parent())) diagnostic->when(kNotSimple);
    if (!drake_joints.contains(one.name)) continue;
    diagnostic->when(drake::kDrakeJoint);
    diagnostic->note(drake::kJointNote);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::loses,
     "ros_control finds no joint for its actuator and does not start the controller",
     "ros_control, read"},
    {&readers::drake, Effect::takes, "knows the joint", kRun, when(drake::kDrakeJoint)},
    {&readers::drake, Effect::ignores, "ignores a transmission of this type", kRun,
     when(kNotSimple)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1443_transmission_joint_unknown{
    .id = "SML1443",
    .name = "transmission-joint-unknown",
    .severity = Severity::warning,
    .summary = "A transmission names a joint that the robot does not have.",
    .remedy = "Correct the name.",
    .sources = "14 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1443_transmission_joint_unknown_file
