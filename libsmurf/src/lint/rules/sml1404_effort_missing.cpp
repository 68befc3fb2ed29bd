// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || joint.limit->effort.written) return;
    if (is_empty_limit(model, joint)) return;  // SML1403
    if (is_slip(model, joint.limit->element, "effort", findings)) return;
    findings.report(tag_name(model, joint.limit->element),
                    "the limit of " + title(joint) + " has no `effort`");
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::refuses, "refuses the file", kRun},
    {&readers::pybullet, Effect::changes, "reads 0: the joint has no force",
     "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::takes, "needs no effort", kRun},
    {&readers::drake, Effect::changes, "reads infinity", "Drake detail_urdf_parser.cc"},
};

}  // namespace

extern constinit const Rule sml1404_effort_missing{.id = "SML1404",
                                                   .name = "effort-missing",
                                                   .severity = Severity::error,
                                                   .summary = "A limit has no effort.",
                                                   .why = "Isaac uses the largest float.",
                                                   .remedy = "Write the effort limit of the drive.",
                                                   .check_model = check,
                                                   .facts = kFacts};

}  // namespace smurf::rules
