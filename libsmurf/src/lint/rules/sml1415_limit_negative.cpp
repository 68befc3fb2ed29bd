// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "base/readers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1415_limit_negative_file {
namespace {

void check_value(const urdf::Joint& joint, const Field<double>& limit, const char* name,
                 Findings& findings) {
  if (!limit || *limit >= 0) return;
  findings.report(limit.span, "the " + std::string(name) + " limit of " + title(joint) + " is " +
                                  format_number(*limit));
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit) return;
    check_value(joint, joint.limit->effort, "effort", findings);
    check_value(joint, joint.limit->velocity, "velocity", findings);
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
     "Drake detail_urdf_parser.cc:930-1001", at("@effort")},
    {&readers::drake, Effect::refuses, "throws an exception", "Drake joint.h:435"},
    {&readers::phobos, Effect::takes, "keeps the number", kRun},
    {&readers::pinocchio, Effect::takes, "has no limits of such a joint", kRun, when(kInFixed)},
    {&readers::pinocchio, Effect::takes, "has no limits of such a joint", kRun, when(kInFloating)},
    {&readers::pinocchio, Effect::takes, "has no limits of such a joint", kRun, when(kInPlanar)},
    {&readers::pinocchio, Effect::refuses, "refuses the joint", kRun},
};
constexpr std::string_view kFormer[] = {"SML1417", "effort-negative", "velocity-negative"};

}  // namespace

extern constinit const Rule sml1415_limit_negative{
    .id = "SML1415",
    .name = "limit-negative",
    .severity = Severity::error,
    .summary = "The effort or velocity limit of a joint is negative.",
    .remedy = "Write a positive number.",
    .check_model = check,
    .facts = kFacts,
    .former = kFormer};

}  // namespace smurf::rules::sml1415_limit_negative_file
