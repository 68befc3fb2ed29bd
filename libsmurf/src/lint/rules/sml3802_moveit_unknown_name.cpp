// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/lists.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3802_moveit_unknown_name_file {
namespace {

constexpr Circumstance kMoveitControllers{"moveit controllers"};

const Companion* file_of(const Companions& companions, const Reference& one) {
  for (const Companion& file : companions.files) {
    if (file.source == one.span.source) return &file;
  }
  return nullptr;
}

void check_group(const srdf::Description& srdf, const Reference& one, Findings& findings) {
  if (srdf.find_group(one.name) != nullptr) return;
  std::vector<std::string_view> known;
  for (const srdf::Group& group : srdf.groups) {
    if (group.name) known.push_back(*group.name);
  }
  Diagnostic& found =
      findings.report(one.span, "the SRDF of the robot has no group " + quoted(one.name));
  if (const auto near = findings.suggest(one.name, known)) {
    found.help("did you mean " + quoted(*near) + "?");
    found.fixes.push_back({Applicability::unsafe, {{one.span, std::string(*near)}}});
  } else {
    found.help("write " + (known.empty() ? "the name of a group" : choices(known)) +
               ", or delete the entry");
  }
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Companion* only = only_srdf(companions);
  const srdf::Description* srdf = only != nullptr ? &*only->srdf : nullptr;
  for (const Reference& one : companion_references(model, companions)) {
    const Companion* file = file_of(companions, one);
    if (file == nullptr || file->srdf || file->kind == CompanionKind::controllers) continue;
    if (one.kinds == NameKind::group) {
      if (srdf != nullptr && file->folder == only->folder) {
        check_group(*srdf, one, findings);
      }
    } else if (one.kinds == NameKind::joint && !one.is_known()) {
      // SRDFs define virtual joints.
      if (srdf != nullptr && srdf->find_virtual_joint(one.name) != nullptr) continue;
      const std::string subject(spec_of(file->kind).title);
      Diagnostic* found =
          check_reference(model, NameKind::joint, one.name, one.span, subject.c_str(), findings);
      if (found != nullptr && file->kind == CompanionKind::moveit_controllers)
        found->when(kMoveitControllers);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "does not execute trajectories that need the joint",
     "moveit2 trajectory_execution_manager.cpp", when(kMoveitControllers)},
    {&readers::moveit, Effect::loses, "ignores the entry without a message",
     "moveit2 robot_model_loader.cpp, planning_context_manager.cpp"},
};

}  // namespace

extern constinit const Rule sml3802_moveit_unknown_name{
    .id = "SML3802",
    .name = "moveit-unknown-name",
    .severity = Severity::warning,
    .summary = "A parameter file of MoveIt names a joint or a group that does not exist.",
    .remedy = "Correct the name.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3802_moveit_unknown_name_file
