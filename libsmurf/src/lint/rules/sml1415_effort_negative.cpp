// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || !joint.limit->effort || *joint.limit->effort >= 0) return;
    findings.report(joint.limit->effort.span, "the effort limit of " + title(joint) + " is " +
                                                  format_number(*joint.limit->effort));
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::takes, "keeps the number", kRun},
    {&readers::mujoco, Effect::changes, "uses the absolute value", kRun},
    {&readers::drake, Effect::refuses, "refuses the file when a transmission drives the joint",
     "Drake detail_urdf_parser.cc:930-1001"},
};

}  // namespace

extern constinit const Rule sml1415_effort_negative{.id = "SML1415",
                                                    .name = "effort-negative",
                                                    .severity = Severity::error,
                                                    .summary =
                                                        "The effort limit of a joint is negative.",
                                                    .remedy = "Write a positive number.",
                                                    .check_model = check,
                                                    .facts = kFacts};

}  // namespace smurf::rules
