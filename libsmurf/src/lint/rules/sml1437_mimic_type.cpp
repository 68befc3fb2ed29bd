// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/mimic_queries.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1437_mimic_type_file {
namespace {

/// Neither the joint nor its leader moves.
constexpr Circumstance kBothFixed{"both fixed"};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for (std::uint32_t i = 0; i < model.robot->joints.size(); ++i) {
    const urdf::Joint& joint = model.robot->joints[i];
    if (!joint.mimic || joint.type == urdf::JointType::unknown) continue;
    if (!joint.has_one_axis()) {
      Diagnostic& finding =
          findings.report(tag_name(model, joint.mimic->element),
                          title(joint) + " is " + *joint.type_name + ", so it cannot mimic");
      const auto leader = mimic_leader(model, i);
      const bool are_fixed = joint.type == urdf::JointType::fixed && leader &&
                             model.robot->joints[*leader].type == urdf::JointType::fixed;
      if (are_fixed) finding.when(kBothFixed);
      continue;
    }
    const auto index = mimic_leader(model, i);
    if (!index) continue;
    const urdf::Joint& leader = model.robot->joints[*index];
    if (leader.has_one_axis() || leader.type == urdf::JointType::unknown) continue;
    findings
        .report(joint.mimic->joint.span,
                title(joint) + " mimics " + title(leader) + ", which is " + *leader.type_name)
        .label(leader.type_name.span, "has no single position to follow");
  }
}

constexpr Fact kFacts[] = {
    {&readers::drake, Effect::ignores, "ignores mimic in a floating joint", kRun,
     when(kInFloating)},
    {&readers::drake, Effect::ignores, "couples two joints that do not move", kRun,
     when(kBothFixed)},
    {&readers::drake, Effect::refuses, "refuses to couple joints of different degrees of freedom",
     kRun},
};

}  // namespace

extern constinit const Rule sml1437_mimic_type{
    .id = "SML1437",
    .name = "mimic-type",
    .severity = Severity::warning,
    .summary = "A joint that mimics another or is mimicked does not have exactly one axis.",
    .why = "A fixed joint has no position, so it can neither follow nor lead.",
    .remedy = "Let only revolute, continuous and prismatic joints mimic one another.",
    .sources = "Pinocchio model.cpp:140, 213.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1437_mimic_type_file
