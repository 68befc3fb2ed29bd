// SPDX-License-Identifier: BSD-3-Clause
#include "lint/habit.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1424_irrelevant_child_file {
namespace {

/// Elements without effect of the same kind, and the edits that delete them.
struct Useless {
  Habit habit{};
  std::vector<Edit> removals{};

  void add(const urdf::Joint& joint, xml::View child) {
    habit.add(child.name_span(), title(joint) + " is " + *joint.type_name + ", so its " +
                                     quoted(child.name()) + " has no effect");
    removals.push_back({child.span(), ""});
  }

  void report(Applicability applicability, std::string help, Findings& findings) {
    Diagnostic* diagnostic = habit.report("such elements", findings);
    if (diagnostic == nullptr) return;
    diagnostic->help(std::move(help));
    diagnostic->fixes.push_back({applicability, std::move(removals)});
  }
};

/// One finding per file: an exporter writes such elements into all fixed joints.
/// People fix a joint for an afternoon. Its limits and damping are lost when they are deleted,
/// while an axis of a fixed joint is what exporters write.
void check(const LinkedModel& model, Findings& findings) {
  Useless axes;
  Useless settings;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool is_fixed = joint.type == urdf::JointType::fixed;
    if (!is_fixed && joint.type != urdf::JointType::floating) return;
    for (const xml::View child : xml::View(model.robot->document, joint.element)) {
      const bool is_setting = child.name() == "limit" || child.name() == "dynamics";
      if (child.name() == "axis") axes.add(joint, child);
      if (is_fixed && is_setting) settings.add(joint, child);
    }
  });
  axes.report(Applicability::safe, "delete it", findings);
  settings.report(Applicability::unsafe, "delete it, unless the joint is to move again", findings);
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
