// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <set>
#include <string_view>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml3215_joint_without_task_file {
namespace {

/// The name of the section, which may be empty; none: no tasks are looked up.
std::optional<Span> section_of_tasks(const LinkedModel& model) {
  for (const ModelFile& file : model.files) {
    if (!file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    if (const yaml::View section = root.find("joint_tasks")) return section.key_span();
  }
  return std::nullopt;
}

void check(const LinkedModel& model, Findings& findings) {
  const std::optional<Span> section = section_of_tasks(model);
  if (!section || !model.robot) return;
  std::set<std::string_view> names;
  for (const JointTask& task : model.annotations.joint_tasks) {
    if (task.name) names.insert(*task.name);
  }
  for (const urdf::Joint& joint : model.robot->joints) {
    if (!joint.is_movable() || !joint.name || names.contains(*joint.name)) continue;
    findings
        .report(*section, "`joint_tasks` has no entry for the movable joint " + quoted(*joint.name))
        .label(joint.name.span, "the joint")
        .help("add an entry with this name, or delete the section");
  }
}

constexpr Fact kFacts[] = {
    {&readers::envire, Effect::crashes, "ends with an uncaught exception",
     "rock-cpp/smurf Robot.cpp:128-151"},
    {&readers::mars, Effect::takes, "does not read the section", "MARS smurf.cpp:257-485"},
    {&readers::mars2, Effect::takes, "does not read the section", "MARS smurf.cpp:257-485"},
    {&readers::phobos, Effect::takes, "does not read the section", "Phobos io/smurfrobot.py"},
};

}  // namespace

extern constinit const Rule sml3215_joint_without_task{
    .id = "SML3215",
    .name = "joint-without-task",
    .severity = Severity::error,
    .summary = "A model has `joint_tasks`, but no entry for one of its movable joints.",
    .why = "A reader of this section looks for the task of every movable joint.",
    .remedy = "Add an entry with `name`, `provider`, `port` and `driver`, or delete the section.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3215_joint_without_task_file
