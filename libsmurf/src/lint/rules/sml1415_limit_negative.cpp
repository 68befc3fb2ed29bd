// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <string_view>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1415_limit_negative_file {
namespace {

constexpr Circumstance kDriven{"driven by a transmission"};

using Names = std::set<std::string_view>;

/// Joints that a `<transmission>` drives.
Names driven_joints(const LinkedModel& model) {
  Names driven;
  if (!model.robot) return driven;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View extension(model.robot->document, id);
    if (extension.name() != "transmission") continue;
    for (const xml::View part : extension) {
      const xml::Attribute* name = part.name() == "joint" ? part.attribute("name") : nullptr;
      if (name != nullptr) driven.insert(name->value());
    }
  }
  return driven;
}

void check_value(const Names& driven, const urdf::Joint& joint, const Field<double>& limit,
                 const char* name, Findings& findings) {
  if (!limit || *limit >= 0) return;
  Diagnostic& diagnostic =
      findings.report(limit.span, "the " + std::string(name) + " limit of " + title(joint) +
                                      " is " + format_number(*limit));
  if (joint.name && driven.contains(*joint.name)) diagnostic.when(kDriven);
}

void check(const LinkedModel& model, Findings& findings) {
  const Names driven = driven_joints(model);
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit) return;
    check_value(driven, joint, joint.limit->effort, "effort", findings);
    check_value(driven, joint, joint.limit->velocity, "velocity", findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::changes, "keeps the number", kRun},
    {&readers::urdfdom, Effect::takes, "keeps the number", kRun},
    {&readers::ros, Effect::changes, "MoveIt uses the absolute value", "MoveIt robot_model.cpp:874",
     at("@velocity")},
    {&readers::mujoco, Effect::changes, "uses the absolute value", kRun, at("@effort")},
    {&readers::mujoco, Effect::takes, "has no velocity limits", kRun},
    {&readers::drake, Effect::refuses, "refuses the file when a transmission drives the joint",
     kRun, at("@effort").when(kDriven)},
    {&readers::drake, Effect::takes, "needs effort limits for actuators only", kRun, at("@effort")},
    {&readers::drake, Effect::crashes, "ends the process", kRun},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
    {&readers::pinocchio, Effect::takes, "has no limits of such a joint", kRun, when(kInFixed)},
    {&readers::pinocchio, Effect::takes, "has no limits of such a joint", kRun, when(kInFloating)},
    {&readers::pinocchio, Effect::takes, "has no limits of such a joint", kRun, when(kInPlanar)},
    {&readers::pinocchio, Effect::refuses, "refuses the joint", kRun},
};

}  // namespace

extern constinit const Rule sml1415_limit_negative{
    .id = "SML1415",
    .name = "limit-negative",
    .severity = Severity::error,
    .summary = "The effort or velocity limit of a joint is negative.",
    .remedy = "Write a positive number.",
    .check_model = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml1415_limit_negative_file
