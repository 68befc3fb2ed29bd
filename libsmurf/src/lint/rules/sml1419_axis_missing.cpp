// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules::sml1419_axis_missing_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.has_one_axis() || joint.axis_element != xml::kNoElement) return;
    findings.report(name_place(model, joint), title(joint) + " has no axis, so it moves about x")
        .help("write `<axis xyz=\"1 0 0\"/>` if that is meant");
  });
}

}  // namespace

extern constinit const Rule sml1419_axis_missing{
    .id = "SML1419",
    .name = "axis-missing",
    .severity = Severity::warning,
    .summary = "A movable joint has no axis.",
    .why = "The default axis is x; most authors expect z.",
    .remedy = "Write the axis.",
    .sources = "urdfdom, executed.",
    .check_model = check};

}  // namespace smurf::rules::sml1419_axis_missing_file
