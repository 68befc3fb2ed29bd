// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/limit_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || joint.limit->velocity.written) return;
    if (is_empty_limit(model, joint)) return;  // SML1403
    if (is_slip(model, joint.limit->element, "velocity", findings)) return;
    findings.report(tag_name(model, joint.limit->element),
                    "the limit of " + title(joint) + " has no `velocity`");
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::refuses, "refuses the file", kRun},
    {&readers::pybullet, Effect::changes, "reads 0", "Bullet UrdfParser.cpp, run"},
    {&readers::mujoco, Effect::takes, "has no velocity limits", kRun},
    {&readers::drake, Effect::changes, "reads infinity", "Drake detail_urdf_parser.cc"},
};

}  // namespace

extern constinit const Rule sml1405_velocity_missing{.id = "SML1405",
                                                     .name = "velocity-missing",
                                                     .severity = Severity::error,
                                                     .summary = "A limit has no velocity.",
                                                     .why = "urdf-rs refuses the whole file.",
                                                     .remedy =
                                                         "Write the velocity limit of the drive.",
                                                     .check_model = check,
                                                     .facts = kFacts};

}  // namespace smurf::rules
