// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/habit.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// One finding per file, because authors name all parts by one scheme.
void check(const LinkedModel& model, Findings& findings) {
  Habit habit;
  Span link_name;
  bool has_movable = false;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.name || joint.name->empty()) return;
    const auto link = model.link_names.find(*joint.name);
    if (!link) return;
    if (habit.is_first()) link_name = model.robot->links[*link].name.span;
    has_movable = has_movable || joint.type != urdf::JointType::fixed;
    habit.add(joint.name.span, "a link and a joint are both called " + quoted(*joint.name));
  });
  Diagnostic* diagnostic = habit.report("such names", findings);
  if (diagnostic == nullptr) return;
  diagnostic->label(link_name, "the link");
  if (!has_movable) diagnostic->construct = "fixed";
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::takes, "merges the link into its parent, so its name disappears",
     kRun, "#fixed"},
    {&readers::gazebo, Effect::refuses, "reports errors E2 and E24; the model cannot be used",
     kRun},
};

}  // namespace

extern constinit const Rule sml1303_link_joint_same_name{
    .id = "SML1303",
    .name = "link-joint-same-name",
    .severity = Severity::warning,
    .summary = "A link and a joint have the same name.",
    .why = "URDF itself allows it.",
    .remedy = "Give the joint another name, e.g. with the ending `_joint`.",
    .sources = "9 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules
