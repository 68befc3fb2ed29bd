// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <set>

#include "lint/companions/moveit_files.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3806_moveit_kinematics_file {
namespace {

constexpr Circumstance kAttempts{"attempts"};
constexpr Circumstance kNoChain{"no chain"};

/// The next joint above one that is in the group.
std::optional<JointIndex> next_above(const LinkedModel& model, const GroupJoints& joints,
                                     JointIndex from) {
  std::size_t left = model.robot->joints.size();  // a ring of joints ends, too
  std::optional<LinkIndex> link = model.tree.joint_parent[to_size(from)];
  while (link && left-- > 0) {
    const auto up = model.tree.parent_joint[to_size(*link)];
    if (!up || joints.of_robot[to_size(*up)]) return up;
    link = model.tree.joint_parent[to_size(*up)];
  }
  return std::nullopt;
}

/// Whether the movable joints of a group are one chain: each has one joint below it.
bool is_chain(const LinkedModel& model, GroupJoints joints) {
  std::size_t roots = 0;
  std::set<JointIndex> with_child;
  for (std::size_t i = 0; i < joints.of_robot.size(); ++i) {
    const urdf::Joint& one = model.robot->joints[i];
    if (one.type == urdf::JointType::fixed || one.mimic) joints.of_robot[i] = false;
  }
  for (std::size_t i = 0; i < joints.of_robot.size(); ++i) {
    if (!joints.of_robot[i]) continue;
    const auto up = next_above(model, joints, JointIndex{static_cast<std::uint32_t>(i)});
    if (up ? !with_child.insert(*up).second : ++roots > 1) return false;
  }
  return true;
}

void check_group(const LinkedModel& model, const srdf::Description& srdf, yaml::View group,
                 Findings& findings) {
  const srdf::Group* known = srdf.find_group(group.key());
  const yaml::View solver = group.find("kinematics_solver");
  if (known == nullptr || !model.robot || !solver || !solver.is_scalar()) return;
  if (solver.text() != "kdl_kinematics_plugin/KDLKinematicsPlugin") return;
  const GroupJoints joints = joints_of(model, srdf, *known);
  if (!joints.is_complete || is_chain(model, joints)) return;
  findings
      .report(solver.span(),
              "the KDL solver needs a chain, but the group " + quoted(group.key()) + " branches")
      .help("choose another solver, or name a group that is one chain")
      .when(kNoChain);
}

void check_file(const LinkedModel& model, const Companion& file, const srdf::Description* srdf,
                yaml::View root, Findings& findings) {
  for (const yaml::View member : root) {
    if (member.is_repeated() || !member.is_mapping()) continue;
    if (!member.find("kinematics_solver")) {
      if (is_moveit_wrapper(member.key())) check_file(model, file, srdf, member, findings);
      continue;
    }
    if (srdf != nullptr) check_group(model, *srdf, member, findings);
    const yaml::View attempts = member.find("kinematics_solver_attempts");
    if (!attempts || !file.is_ros2) continue;
    Diagnostic& found = findings.report(
        attempts.key_span(), "MoveIt does not read " + quoted(attempts.key()) + " any more");
    found.severity = Severity::info;
    found.when(kAttempts);
    found.help("delete it");
  }
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Companion* only = only_srdf(companions);
  for_each_file(companions, CompanionKind::kinematics, [&](const Companion& file, yaml::View root) {
    const bool is_near = only != nullptr && file.folder == only->folder;
    check_file(model, file, is_near ? &*only->srdf : nullptr, root, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::ignores, "does not read it", "moveit2 kinematics_parameters.yaml",
     when(kAttempts)},
    {&readers::moveit, Effect::breaks, "reports an error and has no solver for the group",
     "moveit2 kdl_kinematics_plugin.cpp:142"},
};

}  // namespace

extern constinit const Rule sml3806_moveit_kinematics{
    .id = "SML3806",
    .name = "moveit-kinematics",
    .severity = Severity::warning,
    .summary =
        "A group of kinematics.yaml is not one chain, which KDL needs, or it has a key of older versions.",
    .remedy = "Choose another solver or another group; delete the old key.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3806_moveit_kinematics_file
