// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3510_srdf_empty_group_file {
namespace {

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::Group& group : srdf.groups) {
      const std::string title = title_of("group", group.name);
      const Span place = place_of(srdf, group.name, group.element);
      if (group.members.empty()) {
        findings.report(place, title + " has no members")
            .help("write links, joints, chains or groups into it, or delete it");
        continue;
      }
      if (!model.robot) continue;
      const GroupJoints joints = joints_of(model, srdf, group);
      const bool has_joint =
          !joints.virtual_joints.empty() ||
          std::find(joints.of_robot.begin(), joints.of_robot.end(), true) != joints.of_robot.end();
      // A link without a parent joint brings the joint of the root.
      const bool has_root =
          std::any_of(group.members.begin(), group.members.end(), [](const srdf::Member& one) {
            return one.kind != srdf::Member::Kind::chain;
          });
      if (has_joint || has_root || !joints.is_complete) continue;
      findings.report(place, title + " has no joint").help("write a chain of two links");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "warns and does not make the group",
     "moveit2 robot_model.cpp addJointModelGroup"},
};

}  // namespace

extern constinit const Rule sml3510_srdf_empty_group{
    .id = "SML3510",
    .name = "srdf-empty-group",
    .severity = Severity::error,
    .summary = "A group of an SRDF has no joint.",
    .remedy = "Write links, joints, chains or groups into it, or delete it.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3510_srdf_empty_group_file
