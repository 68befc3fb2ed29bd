// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/readers.hpp"
#include "base/rules.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// Readers do not treat the link as a root, because a joint leads to it.
bool has_other_roots(const LinkedModel& model, std::string_view link) {
  std::size_t count = 0;
  for (const LinkIndex root : model.tree.roots) {
    count += model.link(root).name.value_or("") != link ? 1 : 0;
  }
  return count > 1;
}

/// Whether no other joint leads to the link, so that readers that start at the root never reach it.
bool is_apart(const LinkedModel& model, std::string_view link) {
  const std::vector<urdf::Joint>& joints = model.robot->joints;
  return !model.tree.roots.empty() &&
         std::none_of(joints.begin(), joints.end(), [&](const urdf::Joint& joint) {
           return joint.child.value_or("") == link && joint.parent.value_or("") != link;
         });
}

bool is_only_root(const LinkedModel& model, std::string_view link) {
  return model.tree.roots.size() == 1 && model.link(model.tree.roots[0]).name.value_or("") == link;
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.parent || !joint.child || *joint.parent != *joint.child) return;
    if (!model.link_names.contains(*joint.child)) return;  // SML1201 reports the unknown link
    Diagnostic& diagnostic =
        findings.report(joint.child.span,
                        title(joint) + " connects the link " + quoted(*joint.child) + " to itself");
    diagnostic.label(joint.parent.span, "the same link as parent");
    if (is_apart(model, *joint.child)) diagnostic.construct = "apart";
    if (is_only_root(model, *joint.child)) diagnostic.construct = "only-root";
    // The link that it should lead to is a root then, which is not reported for itself.
    if (has_other_roots(model, *joint.child)) {
      diagnostic.consequences.push_back(&rules::sml1204_several_roots);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::refuses, "finds no root link, and refuses the file", kRun,
     "#only-root"},
    {&readers::gazebo, Effect::refuses, "finds no root link, and refuses the file", kRun,
     "#only-root"},
    {&readers::dart, Effect::refuses, "finds no root link, and refuses the file", kRun,
     "#only-root"},
    {&readers::urdfdom, Effect::changes, "accepts it; programs that walk the tree never terminate",
     "urdfdom issue 154; check_urdf 3.0.1, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
    {&readers::mars, Effect::loses, "does not reach the link from the root", "urdfdom model.h",
     "#apart"},
    {&readers::mars, Effect::crashes, "never terminates", "MARS 71a5c45, run"},
    {&readers::gazebo, Effect::loses, "does not reach the link from the root", kRun, "#apart"},
    {&readers::dart, Effect::loses, "does not reach the link from the root", kRun, "#apart"},
    {&readers::gazebo, Effect::crashes, "crashes", kRun},
    {&readers::dart, Effect::crashes, "never terminates", kRun},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1207_self_joint{.id = "SML1207",
                                               .name = "self-joint",
                                               .severity = Severity::error,
                                               .summary = "A joint connects a link to itself.",
                                               .remedy = "Name two different links.",
                                               .check_model = check,
                                               .facts = kFacts,
                                               .is_impossible = true,
                                               .blocks_building = true};

}  // namespace smurf::rules
