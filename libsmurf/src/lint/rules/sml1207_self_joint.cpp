// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.parent || !joint.child || *joint.parent != *joint.child) return;
    if (!model.link_names.contains(*joint.child)) return;  // reported where it is unknown
    Diagnostic& diagnostic =
        findings.report(joint.child.span,
                        title(joint) + " connects the link " + quoted(*joint.child) + " to itself");
    diagnostic.labels.push_back({joint.parent.span, "the same link as parent"});
  });
}

}  // namespace

extern constinit const Rule sml1207_self_joint{
    .id = "SML1207",
    .name = "self-joint",
    .severity = Severity::error,
    .summary = "A joint connects a link to itself.",
    .why = "urdfdom accepts it; check_urdf then prints for ever, sdformat 12 crashes and DART "
           "hangs.",
    .remedy = "Name two different links.",
    .sources = "urdfdom 3.0.1 (issue 154), sdformat 12.3 and DART 6.12, executed.",
    .check_model = check};

}  // namespace smurf::rules
