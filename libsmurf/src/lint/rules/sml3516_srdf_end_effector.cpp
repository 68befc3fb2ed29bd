// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3516_srdf_end_effector_file {
namespace {

constexpr Circumstance kShared{"shared"};

/// Whether a joint of the group moves the link.
bool moves(const LinkedModel& model, const GroupJoints& joints, std::string_view link) {
  const auto index = model.link_index(link);
  const auto joint = index ? model.tree.parent_joint[to_size(*index)] : std::nullopt;
  return joint && joints.of_robot[to_size(*joint)];
}

bool is_member(const srdf::Group& group, std::string_view link) {
  return std::any_of(group.members.begin(), group.members.end(), [&](const srdf::Member& one) {
    return one.kind == srdf::Member::Kind::link && one.name && *one.name == link;
  });
}

/// A plan for the parent group would move the fingers, too.
void check_shared_joints(const LinkedModel& model, const srdf::EndEffector& one,
                         const GroupJoints& own, const GroupJoints& parent, Findings& findings) {
  std::string shared;
  for (std::size_t i = 0; i < own.of_robot.size() && i < parent.of_robot.size(); ++i) {
    const urdf::Joint& joint = model.robot->joints[i];
    if (!own.of_robot[i] || !parent.of_robot[i] || !joint.is_movable() || !joint.name) continue;
    shared += (shared.empty() ? "" : ", ") + quoted(*joint.name);
  }
  if (shared.empty()) return;
  Diagnostic& found =
      findings.report(one.parent_group.span, "the parent group " + quoted(*one.parent_group) +
                                                 " of " + title_of("end effector", one.name) +
                                                 " also moves " + shortened(shared, 200));
  found.severity = Severity::info;
  found.when(kShared);
  found.help("write the group of the arm alone");
}

void check_parent_group(const LinkedModel& model, const srdf::Description& srdf,
                        const srdf::EndEffector& one, const srdf::Group& own, Findings& findings) {
  const srdf::Group* parent = one.parent_group ? srdf.find_group(*one.parent_group) : nullptr;
  if (parent == nullptr) return;
  const std::string title = title_of("end effector", one.name);
  if (parent == &own) {
    findings.report(one.parent_group.span, title + " has its own group as parent group")
        .help("write the group of the arm");
    return;
  }
  const GroupJoints joints = joints_of(model, srdf, *parent);
  check_shared_joints(model, one, joints_of(model, srdf, own), joints, findings);
  if (!one.parent_link || !joints.is_complete) return;
  if (moves(model, joints, *one.parent_link) || is_member(*parent, *one.parent_link)) return;
  findings
      .report(one.parent_link.span, title + " is attached to " + quoted(*one.parent_link) +
                                        ", which is not in its parent group " +
                                        quoted(*one.parent_group))
      .help("write a link of the parent group, or another parent group");
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::EndEffector& one : srdf.end_effectors) {
      const srdf::Group* own = one.group ? srdf.find_group(*one.group) : nullptr;
      if (own == nullptr || !one.parent_link || model.find_link(*one.parent_link) == nullptr) {
        continue;
      }
      if (moves(model, joints_of(model, srdf, *own), *one.parent_link)) {
        findings
            .report(one.parent_link.span, title_of("end effector", one.name) + " is attached to " +
                                              quoted(*one.parent_link) +
                                              ", which its own group moves")
            .help("write the link of the arm that carries the end effector")
            .severity = Severity::info;
        continue;
      }
      check_parent_group(model, srdf, one, *own, findings);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::takes, "plans for the parent group with these joints, too",
     "moveit2 robot_model.cpp buildGroupsInfoEndEffectors", when(kShared)},
    {&readers::moveit, Effect::changes, "attaches the end effector to another group, or to none",
     "moveit2 robot_model.cpp buildGroupsInfoEndEffectors"},
};

}  // namespace

extern constinit const Rule sml3516_srdf_end_effector{
    .id = "SML3516",
    .name = "srdf-end-effector",
    .severity = Severity::warning,
    .summary = "The parent link or the parent group of an end effector does not fit its group.",
    .remedy = "Write the link of the arm that carries the end effector, and the group of the arm.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3516_srdf_end_effector_file
