// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <functional>
#include <optional>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1208_detached_cycle_file {
namespace {

/// A link that no root reaches stands before one that a root reaches. Bullet's tables are as long
/// as the number of links that it reaches, and have the indices of all.
constexpr Circumstance kInFront{"in front of what the root reaches"};

/// The parent of a link that no root reaches.
std::size_t parent_of(const LinkedModel& model, std::size_t link) {
  return to_size(*model.tree.joint_parent[to_size(*model.tree.parent_joint[link])]);
}

/// At the joint that comes last in the file, which most likely closes the ring.
Diagnostic& report(const LinkedModel& model, const std::vector<std::size_t>& ring,
                   Findings& findings) {
  std::vector<std::size_t> joints;
  for (const std::size_t link : ring) joints.push_back(to_size(*model.tree.parent_joint[link]));
  std::sort(joints.begin(), joints.end());
  const auto closing = JointIndex{static_cast<std::uint32_t>(joints.back())};
  Diagnostic& diagnostic =
      findings.report(model.joint(closing).child.span,
                      title(model.joint(closing)) + " closes a ring of " +
                          std::to_string(ring.size()) + " links that no root link reaches");
  constexpr std::size_t kShown = 5;
  joints.pop_back();
  for (std::size_t i = 0; i < std::min(joints.size(), kShown); ++i) {
    diagnostic.label(model.robot->joints[joints[i]].child.span, "part of the ring");
  }
  return diagnostic;
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.tree.roots.empty()) return;
  std::vector<bool> is_done = reached_links(model);
  const bool is_in_front = !std::is_sorted(is_done.begin(), is_done.end(), std::greater<>());
  std::optional<bool> is_rooted;  // computed when it is needed
  for (std::size_t i = 0; i < is_done.size(); ++i) {
    // Goes up until a link repeats: the links before it hang below the ring.
    std::vector<std::size_t> path;
    std::size_t at = i;
    for (; !is_done[at]; at = parent_of(model, at)) {
      is_done[at] = true;
      path.push_back(at);
    }
    const auto ring = std::find(path.begin(), path.end(), at);
    if (ring == path.end()) continue;
    Diagnostic& diagnostic = report(model, {ring, path.end()}, findings);
    if (!is_rooted) is_rooted = has_root_with_joints(model);
    if (!*is_rooted) diagnostic.when(kRootless);
    if (is_in_front) diagnostic.when(kInFront);
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::loses, "accepts it; no root reaches the ring", kRun},
    {&readers::pybullet, Effect::crashes,
     "writes outside of its tables, and ends the process at once or later", kRun, when(kInFront)},
    {&readers::pybullet, Effect::changes, "accepts the ring", "Bullet UrdfParser.cpp, run"},
    {&readers::gazebo, Effect::loses, "leaves the ring out", kRun},
    {&readers::dart, Effect::loses, "leaves the ring out", kRun},
    {&readers::mujoco, Effect::refuses, "does not find the bodies of the ring", kRun},
    {&readers::drake, Effect::loses, "leaves out a floating joint", kRun, when(kInFloating)},
    {&readers::drake, Effect::refuses, "refuses the model when it is finalised", kRun},
    {&readers::phobos, Effect::changes, "accepts the ring", kRun},
    {&readers::pinocchio, Effect::loses, "leaves the ring out", kRun},
    {&readers::newton, Effect::refuses, "finds no root, and refuses the file", kRun,
     when(kRootless)},
    {&readers::newton, Effect::loses, "leaves the ring out", kRun},
    {&readers::isaac, Effect::refuses, "finds no root, and refuses the file", kRun,
     when(kRootless)},
    {&readers::isaac, Effect::loses, "leaves the ring out", kRun},
};

}  // namespace

extern constinit const Rule sml1208_detached_cycle{
    .id = "SML1208",
    .name = "detached-cycle",
    .severity = Severity::error,
    .summary = "Links form a ring that the root does not reach.",
    .remedy = "Connect the ring to the rest and remove the joint that closes it.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1208_detached_cycle_file
