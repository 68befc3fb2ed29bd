// SPDX-License-Identifier: BSD-3-Clause
#include "lint/name_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!are_links_named(model)) return;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.child || joint.child->empty()) return;
    check_reference(model, NameKind::link, *joint.child, joint.child.span, subject(joint),
                    findings);
  });
}

}  // namespace

extern constinit const Rule sml1202_child_link_unknown{
    .id = "SML1202",
    .name = "child-link-unknown",
    .severity = Severity::error,
    .summary = "A joint leads to a link that the robot does not have.",
    .why = "urdfdom, sdformat, MuJoCo and Bullet refuse the file; urdf-loader draws half a robot.",
    .remedy = "Correct the name, or declare the link.",
    .sources = "urdfdom 3.0.1, sdformat 12.3, MuJoCo 3.14 and Bullet, executed; urdf_model "
               "model.h:128.",
    .check_model = check};

}  // namespace smurf::rules
