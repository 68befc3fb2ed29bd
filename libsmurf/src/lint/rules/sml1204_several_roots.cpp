// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/drake_queries.hpp"
#include "lint/queries.hpp"
#include "lint/second_parents.hpp"

namespace smurf::rules::sml1204_several_roots_file {
namespace {

/// Joints lead on from the root.
constexpr Circumstance kOfTree{"root of a tree"};

/// Joints that name an unknown link, or one link twice, are reported instead of the roots that they
/// cause, and so is a joint that leads to another link than to the root.
bool has_broken_joints(const LinkedModel& model) {
  if (missed_root(model)) return true;
  for (std::size_t i = 0; i < model.tree.joint_parent.size(); ++i) {
    const auto parent = model.tree.joint_parent[i];
    const auto child = model.tree.joint_child[i];
    if (!parent || !child || *parent == *child) return true;
  }
  return false;
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.tree.roots.size() < 2 || has_broken_joints(model)) return;
  const auto led_to_by_drake = drake::names_in(drake::own_joints(model), "child", "link");
  const urdf::Link& first = model.link(model.tree.roots.front());
  for (std::size_t i = 1; i < model.tree.roots.size(); ++i) {
    const urdf::Link& root = model.link(model.tree.roots[i]);
    // A second link of the same name is reported as a duplicate, not as a root.
    if (root.name && model.link_names.find(*root.name) != to_size(model.tree.roots[i])) continue;
    if (!root.name || root.name->empty()) continue;
    // Readers ignore `Link`, which is reported.
    if (xml::View(model.robot->document, root.element).name() != "link") continue;
    Diagnostic& diagnostic =
        findings.report(name_place(model, root), "no joint leads to " + title(root) +
                                                     ", so the robot has several root links");
    diagnostic.caret = "also a root";
    diagnostic.help("connect it by a joint, or delete it");
    diagnostic.label(name_place(model, first), "the first root link");
    if (!model.tree.child_joints[to_size(model.tree.roots[i])].empty()) diagnostic.when(kOfTree);
    if (!led_to_by_drake.contains(*root.name)) continue;
    diagnostic.when(drake::kDrakeJoint);
    diagnostic.note(drake::kJointNote);
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file: it looks for one root",
     "urdfdom model.h:176, run"},
    {&readers::pybullet, Effect::crashes, "warns, uses the root index -1, and ends the process",
     "BulletUrdfImporter.cpp:316, run"},
    {&readers::mujoco, Effect::changes, "welds every root to the world", kRun},
    {&readers::drake, Effect::takes, "knows the joint that leads to the link", kRun,
     when(drake::kDrakeJoint)},
    {&readers::drake, Effect::takes, "accepts several trees", kRun},
    {&readers::newton, Effect::refuses, "drops the link, and then misses it at its joints", kRun,
     when(kOfTree)},
    {&readers::newton, Effect::loses, "drops links that no joint connects to the first root", kRun},
};

}  // namespace

extern constinit const Rule sml1204_several_roots{
    .id = "SML1204",
    .name = "several-roots",
    .severity = Severity::error,
    .summary = "A robot has more than one root link.",
    .remedy = "Connect the links by joints, or delete unused links.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1204_several_roots_file
