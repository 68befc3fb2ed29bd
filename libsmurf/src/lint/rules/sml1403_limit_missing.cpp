// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules::sml1403_limit_missing_file {
namespace {

constexpr Circumstance kEmpty{"empty"};

std::string_view tag(const LinkedModel& model, const urdf::Limit& limit) {
  return xml::View(model.robot->document, limit.element).name();
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (is_empty_limit(model, joint)) {
      findings
          .report(tag_name(model, joint.limit->element),
                  "the `limit` of " + title(joint) + " is empty")
          .when(kEmpty);
      return;
    }
    const bool needs_limit =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (needs_limit && joint.limit && tag(model, *joint.limit) != "limit") {
      return findings.add_consequence(tag_name(model, joint.limit->element));  // SML1114
    }
    if (!needs_limit || joint.limit || is_slip(model, joint.element, "limit", findings)) return;
    findings
        .report(name_place(model, joint),
                title(joint) + " is " + *joint.type_name + " and has no `limit`")
        .help(std::string(
                  "add `<limit lower=\"...\" upper=\"...\" effort=\"...\" velocity=\"...\"/>`") +
              (joint.type == urdf::JointType::revolute ? ", or make the joint continuous" : ""));
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::refuses, "refuses the file", kRun},
    {&readers::pybullet, Effect::changes, "reads 0 for both limits", kRun, when(kEmpty)},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::changes, "lets the joint move without limit", kRun},
    {&readers::drake, Effect::changes, "lets the joint move without limit", kRun},
    {&readers::phobos, Effect::changes, "keeps a joint without limits", kRun},
};

}  // namespace

extern constinit const Rule sml1403_limit_missing{
    .id = "SML1403",
    .name = "limit-missing",
    .severity = Severity::error,
    .summary = "A revolute or prismatic joint has no limit element, or a limit is empty.",
    .remedy = "Add `<limit lower=\"...\" upper=\"...\" effort=\"...\" velocity=\"...\"/>`, or "
              "make the joint continuous.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1403_limit_missing_file
