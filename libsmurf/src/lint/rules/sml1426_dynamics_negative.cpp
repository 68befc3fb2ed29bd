// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1426_dynamics_negative_file {
namespace {

constexpr Circumstance kOneAxis{"one axis"};

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.dynamics) return;
    for (const Field<double>* value : {&joint.dynamics->damping, &joint.dynamics->friction}) {
      if (!*value || **value >= 0) continue;
      Diagnostic& diagnostic = findings.report(
          value->span,
          std::string(value == &joint.dynamics->damping ? "the damping" : "the friction") + " of " +
              title(joint) + " is " + format_number(**value));
      if (joint.has_one_axis()) diagnostic.when(kOneAxis);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "keeps the number", kRun},
    {&readers::drake, Effect::ignores, "does not look at it", kRun, at("@friction")},
    {&readers::urdfdom, Effect::takes, "keeps the number", kRun},
    {&readers::dart, Effect::crashes, "ends the process with an assertion", kRun,
     when(kOneAxis).before({6, 20})},
    {&readers::dart, Effect::ignores, "reads the dynamics of joints with one axis only", kRun,
     before({6, 20})},
    {&readers::drake, Effect::refuses, "refuses negative damping", kRun},
    {&readers::mujoco, Effect::changes, "reads the number", kRun},
    {&readers::pinocchio, Effect::refuses, "refuses the joint", kRun,
     at("@friction").when(kOneAxis)},
};

}  // namespace

extern constinit const Rule sml1426_dynamics_negative{
    .id = "SML1426",
    .name = "dynamics-negative",
    .severity = Severity::error,
    .summary = "A damping or friction is negative.",
    .why = "In other readers, the joint gains energy.",
    .remedy = "Write a positive number.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1426_dynamics_negative_file
