// SPDX-License-Identifier: BSD-3-Clause
#include "lint/habit.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// What an exporter writes into one fixed joint it writes into all: one finding a file.
void check(const LinkedModel& model, Findings& findings) {
  Habit habit;
  std::vector<Edit> removals;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const bool is_fixed = joint.type == urdf::JointType::fixed;
    if (!is_fixed && joint.type != urdf::JointType::floating) return;
    for (const xml::View child : xml::View(model.robot->document, joint.element)) {
      const bool is_useless = child.name() == "axis" ||
                              (is_fixed && (child.name() == "limit" || child.name() == "dynamics"));
      if (!is_useless) continue;
      habit.add(child.name_span(), title(joint) + " is " + *joint.type_name + ", so its " +
                                       quoted(child.name()) + " has no effect");
      removals.push_back({child.span(), ""});
    }
  });
  Diagnostic* diagnostic = habit.report("such elements", findings);
  if (diagnostic == nullptr) return;
  diagnostic->help = "delete it";
  diagnostic->fixes.push_back({Applicability::safe, std::move(removals)});
}

}  // namespace

extern constinit const Rule sml1424_irrelevant_child{
    .id = "SML1424",
    .name = "irrelevant-child",
    .severity = Severity::info,
    .summary = "A joint has elements that its type does not use.",
    .why = "Readers ignore the axis, limit and dynamics of a fixed joint and the axis of a "
           "floating one; urdfdom writes an axis `0 0 0` into every fixed joint it exports, which "
           "strict readers of other formats refuse.",
    .remedy = "Delete them.",
    .sources = "urdfdom joint.cpp:611-613; 24 of 322 files of the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules
