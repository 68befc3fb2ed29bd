// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
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

}  // namespace

extern constinit const Rule sml1415_effort_negative{
    .id = "SML1415",
    .name = "effort-negative",
    .severity = Severity::error,
    .summary = "The effort limit of a joint is negative.",
    .why = "MuJoCo takes the absolute value, Drake refuses the file when the joint has a "
           "transmission.",
    .remedy = "Write a positive number.",
    .sources = "MuJoCo 3.14, executed; Drake detail_urdf_parser.cc:930-1001.",
    .check_model = check};

}  // namespace smurf::rules
