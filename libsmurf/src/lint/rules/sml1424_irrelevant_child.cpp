// SPDX-License-Identifier: BSD-3-Clause
#include "lint/queries.hpp"

namespace smurf::rules::sml1424_irrelevant_child_file {
namespace {

enum Habit { axes, settings };

/// One finding per file: an exporter writes such elements into all fixed joints.
void report(const urdf::Joint& joint, xml::View child, Habit habit, Findings& findings) {
  Diagnostic& finding =
      findings.report_habit(child.name_span(),
                            title(joint) + " is " + *joint.type_name + ", so its " +
                                quoted(child.name()) + " has no effect",
                            "such elements", habit);
  finding.help(habit == axes ? "delete it" : "delete it, unless the joint is to move again");
  finding.fixes.push_back(
      {habit == axes ? Applicability::safe : Applicability::unsafe, {{child.span(), ""}}});
}

/// People fix a joint for an afternoon. Its limits and damping are lost when they are deleted,
/// while an axis of a fixed joint is what exporters write.
void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool is_fixed = joint.type == urdf::JointType::fixed;
    if (!is_fixed && joint.type != urdf::JointType::floating) return;
    for (const xml::View child : xml::View(model.robot->document, joint.element)) {
      const bool is_setting = child.name() == "limit" || child.name() == "dynamics";
      if (child.name() == "axis") report(joint, child, axes, findings);
      if (is_fixed && is_setting) report(joint, child, settings, findings);
    }
  });
}

}  // namespace

extern constinit const Rule sml1424_irrelevant_child{
    .id = "SML1424",
    .name = "irrelevant-child",
    .severity = Severity::info,
    .summary = "A joint has elements that its type does not use.",
    .why =
        "Readers ignore the axis, limit and dynamics of a fixed joint and the axis of a floating "
        "one. Exporters write an axis `0 0 0` into fixed joints, which strict readers of other "
        "formats refuse.",
    .remedy = "Delete them. Keep limits and dynamics when the joint is to move again.",
    .sources =
        "urdfdom joint.cpp:611-613 (exports `0 0 0`); 24 of 322 files of the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules::sml1424_irrelevant_child_file
