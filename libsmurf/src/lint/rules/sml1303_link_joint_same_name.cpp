// SPDX-License-Identifier: BSD-3-Clause
#include "lint/habit.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// A scheme of names is one decision, so one finding a file.
void check(const LinkedModel& model, Findings& findings) {
  Habit habit;
  Span link_name;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.name || joint.name->empty()) return;
    const auto link = model.link_names.find(*joint.name);
    if (!link) return;
    if (habit.is_first()) link_name = model.robot->links[*link].name.span;
    habit.add(joint.name.span, "the name " + quoted(*joint.name) + " is that of a link as well");
  });
  Diagnostic* diagnostic = habit.report("such names", findings);
  if (diagnostic == nullptr) return;
  diagnostic->labels.push_back({link_name, "the link"});
  diagnostic->notes.push_back("sdformat (Gazebo) cannot load such a model");
}

}  // namespace

extern constinit const Rule sml1303_link_joint_same_name{
    .id = "SML1303",
    .name = "link-joint-same-name",
    .severity = Severity::warning,
    .summary = "A link and a joint have the same name.",
    .why = "sdformat has one name space for both: Gazebo reports errors and cannot use the model. "
           "URDF itself allows it.",
    .remedy = "Give the joint another name, e.g. with the ending `_joint`.",
    .sources = "sdformat 12.3, executed; 9 of 322 files of the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules
