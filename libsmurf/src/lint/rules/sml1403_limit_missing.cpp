// SPDX-License-Identifier: BSD-3-Clause
#include "lint/limit_queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (is_empty_limit(model, joint)) {
      findings.report(tag_name(model, joint.limit->element),
                      "the `limit` of " + title(joint) + " is empty");
      return;
    }
    const bool needs_limit =
        joint.type == urdf::JointType::revolute || joint.type == urdf::JointType::prismatic;
    if (!needs_limit || joint.limit || has_slip(model, joint.element, "limit")) return;
    findings
        .report(name_place(model, joint),
                title(joint) + " is " + *joint.type_name + " and has no `limit`")
        .help = joint.type == urdf::JointType::revolute ? "add one, or make the joint continuous"
                                                        : "add one";
  });
}

}  // namespace

extern constinit const Rule sml1403_limit_missing{
    .id = "SML1403",
    .name = "limit-missing",
    .severity = Severity::error,
    .summary = "A revolute or prismatic joint has no limit element, or a limit is empty.",
    .why = "urdfdom (RViz, Gazebo, Pinocchio, DART) and Bullet refuse the file; Drake and MuJoCo "
           "let the joint turn without end.",
    .remedy = "Add `<limit lower=\"...\" upper=\"...\" effort=\"...\" velocity=\"...\"/>`, or "
              "make the joint continuous.",
    .sources = "urdfdom 3.0.1, Bullet and MuJoCo 3.14, executed.",
    .check_model = check};

}  // namespace smurf::rules
