// SPDX-License-Identifier: BSD-3-Clause
#include <string_view>
#include <vector>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "base/text/lists.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1919_part_merged_away_file {
namespace {

/// Ends of legs and arms, which policies and contact sensors name.
constexpr std::string_view kEnds[] = {"foot", "feet", "toe", "ankle", "sole"};

bool is_end(const urdf::Link& link) {
  const std::string name = path::to_lower(link.name.value_or(""));
  return ranges::any_of(
      kEnds, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

bool is_kept(const LinkedModel& model, const urdf::Joint& joint) {
  const xml::Attribute* kept =
      xml::View(model.robot->document, joint.element).attribute("dont_collapse");
  return kept != nullptr && kept->value() == "true";
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::vector<std::string> merged;
  const urdf::Joint* first = nullptr;
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const urdf::Joint& joint = model.robot->joints[i];
    const auto child = model.tree.joint_child[i];
    const auto parent = model.tree.joint_parent[i];
    if (joint.type != urdf::JointType::fixed || !child || !parent) continue;
    const urdf::Link& link = model.link(*child);
    // Below a joint that moves, so that it belongs to a leg.
    if (!is_end(link) || link.collisions.empty() || is_kept(model, joint)) continue;
    if (!model.tree.parent_joint[to_size(*parent)]) continue;
    if (merged.empty()) first = &joint;
    merged.push_back(quoted(link.name.value_or("")));
  }
  if (merged.empty()) return;
  constexpr std::size_t kShown = 6;
  findings
      .report(name_place(model, *first),
              "Isaac Lab merges " + shortlist(merged, kShown) +
                  (merged.size() == 1 ? " into its parent" : " into their parents"))
      .help("add `dont_collapse=\"true\"` to the fixed joint, or set `merge_fixed_joints=False`");
}

constexpr Fact kFacts[] = {
    {&readers::isaac, Effect::changes,
     "merges links at fixed joints by default (Isaac Lab), so that nothing can name them",
     "IsaacLab UrdfConverterCfg.merge_fixed_joints, read"},
};

}  // namespace

extern constinit const Rule sml1919_part_merged_away{
    .id = "SML1919",
    .name = "part-merged-away",
    .severity = Severity::warning,
    .summary = "A foot is at a fixed joint, and a target merges such links into their parents.",
    .why = "Contact sensors, rewards and observations name the feet; after the merge, no body has "
           "that name.",
    .remedy =
        "Add `dont_collapse=\"true\"` to the joint, or import with `merge_fixed_joints=False`.",
    .sources = "rl_training issue 6.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1919_part_merged_away_file
