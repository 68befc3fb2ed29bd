// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules::sml1404_limit_incomplete_file {
namespace {

constexpr Circumstance kEffort{"effort"};

void check_value(const LinkedModel& model, const urdf::Joint& joint, bool is_written,
                 const char* name, Findings& findings) {
  if (is_written || is_slip(model, joint.limit->element, name, findings)) return;
  Diagnostic& diagnostic =
      findings.report(tag_name(model, joint.limit->element),
                      "the limit of " + title(joint) + " has no " + quoted(name));
  if (name == std::string_view("effort")) diagnostic.when(kEffort);
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || is_empty_limit(model, joint)) return;  // SML1403
    check_value(model, joint, joint.limit->effort.written, "effort", findings);
    check_value(model, joint, joint.limit->velocity.written, "velocity", findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::refuses, "refuses the file", kRun},
    {&readers::pybullet, Effect::changes, "reads 0: the joint has no force",
     "Bullet UrdfParser.cpp, run", when(kEffort)},
    {&readers::pybullet, Effect::changes, "reads 0", "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::takes, "needs neither effort nor velocity", kRun},
    {&readers::drake, Effect::changes, "reads infinity", kRun},
};

}  // namespace

extern constinit const Rule sml1404_limit_incomplete{
    .id = "SML1404",
    .name = "limit-incomplete",
    .severity = Severity::error,
    .summary = "A limit has no effort or no velocity.",
    .why = "urdf-rs refuses the whole file.",
    .remedy = "Write the effort and velocity limits of the drive.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1404_limit_incomplete_file
