// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <numeric>
#include <optional>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "lint/queries.hpp"
#include "lint/second_parents.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1206_link_with_two_parents_file {
namespace {

constexpr Circumstance kFixed{"fixed"};
constexpr Circumstance kMergedTwice{"merged twice"};
constexpr Circumstance kRing{"ring"};
constexpr Circumstance kParentFirst{"parent first"};

/// True when the link is the other one or a descendant of it.
bool is_below(const LinkedModel& model, LinkIndex link, LinkIndex other) {
  for (std::size_t step = 0; step <= model.robot->joints.size() && link != other; ++step) {
    const auto above = model.tree.parent_joint[to_size(link)];
    if (!above || !model.tree.joint_parent[to_size(*above)]) return false;
    link = *model.tree.joint_parent[to_size(*above)];
  }
  return link == other;
}

/// sdformat merges a link into both parents if the joint that it keeps is fixed, which is the last
/// one in alphabetical order, and no other link moves below.
class MergedLinks {
 public:
  explicit MergedLinks(const LinkedModel& model)
      : last_(model.robot->links.size()), has_motion_below_(model.robot->links.size()) {
    for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
      const urdf::Joint& joint = model.robot->joints[i];
      const auto child = model.tree.joint_child[i];
      if (!child || !joint.name) continue;
      const urdf::Joint*& last = last_[to_size(*child)];
      if (last == nullptr || *last->name < *joint.name) last = &joint;
    }
    for (auto link = model.tree.order.rbegin(); link != model.tree.order.rend(); ++link) {
      const auto above = model.tree.parent_joint[to_size(*link)];
      if (!above) continue;
      const bool moves = model.joint(*above).type != urdf::JointType::fixed;
      const std::size_t parent = to_size(*model.tree.joint_parent[to_size(*above)]);
      if (moves || has_motion_below_[to_size(*link)]) has_motion_below_[parent] = true;
    }
  }

  /// The joint to a link that urdfdom keeps.
  const urdf::Joint* kept(LinkIndex link) const { return last_[to_size(link)]; }

  bool contains(LinkIndex link) const {
    const urdf::Joint* last = kept(link);
    return last != nullptr && last->type == urdf::JointType::fixed &&
           last->parent.value_or("") != "world" &&  // which is no link in SDF
           !has_motion_below_[to_size(link)];
  }

 private:
  std::vector<const urdf::Joint*> last_;
  std::vector<bool> has_motion_below_;
};

/// By link: when Pinocchio comes to it first, which goes down the joints in alphabetical order.
std::vector<std::size_t> visits(const LinkedModel& model) {
  const std::size_t joints = model.robot->joints.size();
  std::vector<std::size_t> by_name(joints);
  std::iota(by_name.begin(), by_name.end(), std::size_t{0});
  std::stable_sort(by_name.begin(), by_name.end(), [&](std::size_t a, std::size_t b) {
    return model.robot->joints[a].name.value_or("") < model.robot->joints[b].name.value_or("");
  });
  std::vector<std::vector<LinkIndex>> below(model.robot->links.size());
  for (const std::size_t joint : by_name) {
    const auto parent = model.tree.joint_parent[joint], child = model.tree.joint_child[joint];
    if (parent && child) below[to_size(*parent)].push_back(*child);
  }
  std::vector<std::size_t> visit(below.size(), below.size());
  std::size_t count = 0;
  std::vector<LinkIndex> next(model.tree.roots.rbegin(), model.tree.roots.rend());
  while (!next.empty()) {
    const std::size_t link = to_size(next.back());
    next.pop_back();
    if (visit[link] != below.size()) continue;
    visit[link] = count++;
    next.insert(next.end(), below[link].rbegin(), below[link].rend());
  }
  return visit;
}

/// Whether Pinocchio knows the parent of the joint that urdfdom keeps when it comes to the link.
bool is_parent_first(const LinkedModel& model, const urdf::Joint* kept, LinkIndex link,
                     const std::vector<std::size_t>& visit) {
  const auto parent =
      kept == nullptr || !kept->parent ? std::nullopt : model.link_names.find(*kept->parent);
  return parent && visit[to_size(*parent)] < visit[to_size(link)];
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.tree.roots.empty()) return;  // a loop through the root has its own rule
  const std::vector<urdf::Joint>& joints = model.robot->joints;
  std::optional<MergedLinks> merged;  // computed when they are needed
  std::vector<std::size_t> visit;
  const std::optional<LinkIndex> missed = missed_root(model);
  for (const std::size_t i : second_parents(model)) {
    const LinkIndex child = *model.tree.joint_child[i];
    const urdf::Joint& other = model.joint(*model.tree.parent_joint[to_size(child)]);
    Diagnostic& diagnostic =
        findings.report(joints[i].child.span,
                        title(model.link(child)) + " is already the child of " + title(other));
    if (other.type == urdf::JointType::fixed) diagnostic.when(kFixed);
    if (is_below(model, *model.tree.joint_parent[i], child)) diagnostic.when(kRing);
    if (!merged) {
      merged.emplace(model);
      visit = visits(model);
    }
    if (is_parent_first(model, merged->kept(child), child, visit)) diagnostic.when(kParentFirst);
    if (merged->contains(child)) diagnostic.when(kMergedTwice);
    diagnostic.caret = "a second parent";
    diagnostic.label(other.child.span, "the first joint to this link");
    if (!missed) {
      diagnostic.help("keep one of the two joints; URDF has no closed chains");
      continue;
    }
    diagnostic.consequences.push_back(&rules::sml1204_several_roots);
    const std::string name = quoted(*model.link(*missed).name);
    diagnostic.note("no joint leads to the link " + name);
    const urdf::Joint* swapped = nullptr;
    if (missed == model.tree.joint_parent[i]) swapped = &joints[i];
    const std::size_t first = to_size(*model.tree.parent_joint[to_size(child)]);
    if (missed == model.tree.joint_parent[first]) swapped = &other;
    diagnostic.help(swapped != nullptr
                        ? "are `parent` and `child` of " + title(*swapped) + " swapped?"
                        : "write " + name + " as the child of one of the two joints");
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes,
     "does not notice, and keeps the joint whose name is last in alphabetical order", kRun},
    {&readers::pybullet, Effect::crashes, "ends the process", kRun},
    {&readers::gazebo, Effect::crashes, "crashes", kRun, when(kRing)},
    {&readers::gazebo, Effect::changes, "merges the link into both parents", kRun,
     when(kMergedTwice)},
    {&readers::gazebo, Effect::refuses, "reports a duplicate link", kRun},
    {&readers::dart, Effect::crashes, "never terminates", kRun, when(kRing)},
    {&readers::dart, Effect::changes, "builds the link twice, or never terminates", kRun},
    {&readers::mujoco, Effect::refuses, "refuses several parents", kRun},
    {&readers::isaac, Effect::refuses, "follows the ring until Python stops it", kRun, when(kRing)},
    {&readers::drake, Effect::loses, "leaves out a floating joint", kRun, when(kInFloating)},
    {&readers::drake, Effect::refuses, "refuses the model when it is finalised", kRun},
    {&readers::pinocchio, Effect::crashes, "ends the process", kRun, when(kRing, kParentFirst)},
    {&readers::pinocchio, Effect::changes, "adds the child and what is fixed to it twice", kRun,
     when(kParentFirst)},
    {&readers::pinocchio, Effect::refuses, "finds no body of that name, and refuses the file",
     kRun},
};

}  // namespace

extern constinit const Rule sml1206_link_with_two_parents{
    .id = "SML1206",
    .name = "link-with-two-parents",
    .severity = Severity::error,
    .summary = "A link is the child of more than one joint.",
    .remedy = "URDF cannot describe closed chains: keep one joint, and write the other as a loop "
              "constraint where the target supports it.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules::sml1206_link_with_two_parents_file
