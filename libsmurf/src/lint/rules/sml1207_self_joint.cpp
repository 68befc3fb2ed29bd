// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1207_self_joint_file {
namespace {

constexpr Circumstance kApart{"apart"};
constexpr Circumstance kOnlyRoot{"only root"};

/// The names of roots and of children. Collected once, because every joint of a file may connect a
/// link to itself.
class Tree {
 public:
  explicit Tree(const LinkedModel& model)
      : roots_(model.tree.roots.size()), has_root_with_joints_(smurf::has_root_with_joints(model)) {
    for (const LinkIndex root : model.tree.roots) ++roots_by_name_[view(model.link(root).name)];
    for (const urdf::Joint& joint : model.robot->joints) {
      if (view(joint.child) != view(joint.parent)) reached_.insert(view(joint.child));
    }
  }

  /// Whether there are several roots without the link. Readers do not treat it as one, because a
  /// joint leads to it.
  bool has_other_roots(std::string_view link) const { return roots_ - roots_named(link) > 1; }
  bool has_root_with_joints() const { return has_root_with_joints_; }
  bool is_only_root(std::string_view link) const { return roots_ == 1 && roots_named(link) == 1; }
  /// Whether no other joint leads to the link. Readers that start at the root do not find it then.
  bool is_apart(std::string_view link) const { return roots_ > 0 && !reached_.contains(link); }

 private:
  static std::string_view view(const Field<std::string>& name) {
    return name ? std::string_view(*name) : std::string_view();
  }
  std::size_t roots_named(std::string_view link) const {
    const auto found = roots_by_name_.find(link);
    return found == roots_by_name_.end() ? 0 : found->second;
  }

  std::size_t roots_;
  bool has_root_with_joints_;
  std::unordered_map<std::string_view, std::size_t> roots_by_name_;
  std::unordered_set<std::string_view> reached_;
};

void check(const LinkedModel& model, Findings& findings) {
  std::optional<Tree> tree;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.parent || !joint.child || *joint.parent != *joint.child) return;
    if (!model.link_names.contains(*joint.child)) return;  // SML1201 reports the unknown link
    Diagnostic& diagnostic =
        findings.report(joint.child.span,
                        title(joint) + " connects the link " + quoted(*joint.child) + " to itself");
    diagnostic.label(joint.parent.span, "the same link as parent");
    if (!tree) tree.emplace(model);
    if (tree->is_apart(*joint.child)) diagnostic.when(kApart);
    if (tree->is_only_root(*joint.child)) diagnostic.when(kOnlyRoot);
    if (!tree->has_root_with_joints()) diagnostic.when(kRootless);
    // The link that it should lead to is a root then, which is not reported for itself.
    if (tree->has_other_roots(*joint.child)) {
      diagnostic.consequences.push_back(&rules::sml1204_several_roots);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::crashes, "ends the process", kRun, when(kRootless)},
    {&readers::pybullet, Effect::loses, "does not reach the link from the root", kRun,
     when(kApart)},
    {&readers::pybullet, Effect::crashes, "ends the process", kRun},
    {&readers::drake, Effect::loses, "leaves out a floating joint", kRun, when(kInFloating)},
    {&readers::drake, Effect::refuses, "refuses the file", kRun},
    {&readers::urdfdom, Effect::refuses, "finds no root link, and refuses the file", kRun,
     when(kOnlyRoot)},
    {&readers::gazebo, Effect::refuses, "finds no root link, and refuses the file", kRun,
     when(kOnlyRoot)},
    {&readers::dart, Effect::refuses, "finds no root link, and refuses the file", kRun,
     when(kOnlyRoot)},
    {&readers::urdfdom, Effect::changes, "accepts it; programs that walk the tree never terminate",
     "urdfdom issue 154; check_urdf 3.0.1, run"},
    {&readers::phobos, Effect::refuses, "stops with an exception", "Phobos a613e31, run"},
    {&readers::mars, Effect::loses, "does not reach the link from the root", "urdfdom model.h",
     when(kApart)},
    {&readers::mars, Effect::crashes, "never terminates", "MARS 71a5c45, run"},
    {&readers::gazebo, Effect::loses, "does not reach the link from the root", kRun, when(kApart)},
    {&readers::dart, Effect::loses, "does not reach the link from the root", kRun, when(kApart)},
    {&readers::gazebo, Effect::crashes, "crashes", kRun},
    {&readers::dart, Effect::crashes, "never terminates", kRun},
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::pinocchio, Effect::refuses, "finds no root link, and refuses the file", kRun,
     when(kOnlyRoot)},
    {&readers::pinocchio, Effect::loses, "does not reach the link from the root", kRun,
     when(kApart)},
    {&readers::pinocchio, Effect::crashes, "ends the process", kRun},
    {&readers::newton, Effect::refuses, "finds no root, and refuses the file", kRun,
     when(kRootless)},
    {&readers::newton, Effect::loses, "does not reach the link from the root", kRun, when(kApart)},
    {&readers::newton, Effect::refuses, "refuses a link with two parents", kRun},
    {&readers::isaac, Effect::refuses, "finds no root, and refuses the file", kRun,
     when(kRootless)},
    {&readers::isaac, Effect::loses, "does not reach the link from the root", kRun, when(kApart)},
    {&readers::isaac, Effect::refuses, "follows the link to itself until Python stops it", kRun},
};

}  // namespace

extern constinit const Rule sml1207_self_joint{.id = "SML1207",
                                               .name = "self-joint",
                                               .severity = Severity::error,
                                               .summary = "A joint connects a link to itself.",
                                               .remedy = "Name two different links.",
                                               .check_model = check,
                                               .facts = kFacts,
                                               .about = About::robot,
                                               .blocks_building = true};

}  // namespace smurf::rules::sml1207_self_joint_file
