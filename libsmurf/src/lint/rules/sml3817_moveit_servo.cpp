// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>
#include <vector>

#include "base/text/lists.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/frames.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3817_moveit_servo_file {
namespace {

// The recursion is as deep as the file, whose depth is limited.
void visit(yaml::View mapping, const std::vector<std::string_view>& groups, Findings& findings) {
  for (const yaml::View member : mapping) {
    if (member.is_mapping()) visit(member, groups, findings);
    if (member.key() != "move_group_name" || !member.is_scalar()) continue;
    const std::string_view name = member.text();
    bool is_known = is_placeholder(name) || name.empty();
    for (const std::string_view one : groups) is_known = is_known || one == name;
    if (is_known) continue;
    Diagnostic& found =
        findings.report(member.span(), "the SRDF of the robot has no group " + quoted(name));
    const auto near = findings.suggest(name, groups);
    found.help(near ? "did you mean " + quoted(*near) + "?"
                    : "write one of " + shortened(listed(all_quoted(groups)), 200));
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  const Companion* only = only_srdf(companions);
  if (only == nullptr) return;
  std::vector<std::string_view> groups;
  for (const srdf::Group& one : only->srdf->groups) {
    if (one.name) groups.push_back(*one.name);
  }
  for (const FrameFile& one : companions.surroundings.frame_files) {
    const bool is_near = one.path.starts_with(only->folder + "/");
    if (one.form != FrameFile::Form::parameters || !one.document || !is_near) continue;
    const yaml::View root = one.document->view();
    if (root && root.is_mapping() && !groups.empty()) visit(root, groups, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::refuses, "ends moveit_servo: the group does not exist",
     "moveit2 moveit_servo, branches humble and jazzy"},
};

}  // namespace

extern constinit const Rule sml3817_moveit_servo{
    .id = "SML3817",
    .name = "moveit-servo",
    .severity = Severity::error,
    .summary = "A parameter file of MoveIt Servo names a group that the SRDF does not have.",
    .remedy = "Write the name of a group.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3817_moveit_servo_file
