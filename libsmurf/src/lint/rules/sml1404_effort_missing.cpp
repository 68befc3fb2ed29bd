// SPDX-License-Identifier: BSD-3-Clause
#include "lint/limit_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.limit || joint.limit->effort.written) return;
    if (is_empty_limit(model, joint)) return;  // SML1403
    if (has_slip(model, joint.limit->element, "effort")) return;
    findings.report(tag_name(model, joint.limit->element),
                    "the limit of " + title(joint) + " has no `effort`");
  });
}

}  // namespace

extern constinit const Rule sml1404_effort_missing{
    .id = "SML1404",
    .name = "effort-missing",
    .severity = Severity::error,
    .summary = "A limit has no effort.",
    .why = "urdfdom refuses the whole file; Drake takes infinity, Bullet 0, Isaac the largest "
           "float.",
    .remedy = "Write the effort limit of the drive.",
    .sources = "urdfdom 3.0.1 joint.cpp and Bullet, executed.",
    .check_model = check};

}  // namespace smurf::rules
