// SPDX-License-Identifier: BSD-3-Clause
#include "lint/limit_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || joint.limit->velocity.written) return;
    if (is_empty_limit(model, joint)) return;  // SML1403
    if (has_slip(model, joint.limit->element, "velocity")) return;
    findings.report(tag_name(model, joint.limit->element),
                    "the limit of " + title(joint) + " has no `velocity`");
  });
}

}  // namespace

extern constinit const Rule sml1405_velocity_missing{
    .id = "SML1405",
    .name = "velocity-missing",
    .severity = Severity::error,
    .summary = "A limit has no velocity.",
    .why = "urdfdom and urdf-rs refuse the whole file; others take infinity or 0.",
    .remedy = "Write the velocity limit of the drive.",
    .sources = "urdfdom 3.0.1 joint.cpp and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
