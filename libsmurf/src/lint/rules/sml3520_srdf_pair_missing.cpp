// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/text/counted.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3520_srdf_pair_missing_file {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

Pair ordered(std::string_view a, std::string_view b) { return b < a ? Pair{b, a} : Pair{a, b}; }

/// The pairs that are not checked, and whether any of them is marked as adjacent: an author who
/// lists no neighbours may disable all collisions elsewhere.
struct Listed {
  std::set<Pair> pairs;
  std::set<std::string_view> links;  ///< that are checked against no other
  bool has_adjacent = false;

  explicit Listed(const srdf::Description& srdf) {
    for (const srdf::LinkPair& one : srdf.pairs) {
      if (one.is_enabled || !one.link1 || !one.link2) continue;
      pairs.insert(ordered(*one.link1, *one.link2));
      has_adjacent = has_adjacent || (one.reason && *one.reason == "Adjacent");
    }
    for (const srdf::LinkEntry& one : srdf.links) {
      if (one.link) links.insert(*one.link);
    }
  }
};

bool collides(const LinkedModel& model, std::optional<LinkIndex> link) {
  return link && !model.link(*link).collisions.empty();
}

void check_srdf(const LinkedModel& model, const srdf::Description& srdf, Findings& findings) {
  const Listed listed(srdf);
  if (!listed.has_adjacent) return;
  Diagnostic* found = nullptr;
  std::size_t count = 0;
  for (std::size_t i = 0; i < model.robot->joints.size(); ++i) {
    const auto parent = model.tree.joint_parent[i], child = model.tree.joint_child[i];
    if (!collides(model, parent) || !collides(model, child)) continue;
    const std::string_view a = *model.link(*parent).name, b = *model.link(*child).name;
    const bool is_listed = listed.pairs.contains(ordered(a, b)) || listed.links.contains(a) ||
                           listed.links.contains(b);
    if (is_listed || ++count > 1) continue;
    const xml::View root = srdf.document.view();
    found = &findings.report(root.name_span(), "the neighbours " + quoted(a) + " and " + quoted(b) +
                                                   " are checked for collisions with each other");
    found->label(model.robot->joints[i].name.span, "the joint between them");
    found->help("add `<disable_collisions link1=\"" + std::string(a) + "\" link2=\"" +
                std::string(b) + "\" reason=\"Adjacent\"/>`");
  }
  if (count > 1) found->note("the same is true of " + counted(count - 1, "more pair"));
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    if (srdf.document.view()) check_srdf(model, srdf, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::changes,
     "checks the links against each other; where they touch, each plan starts in a collision",
     "moveit2 collision_matrix.cpp, planning_scene.cpp"},
};

}  // namespace

extern constinit const Rule sml3520_srdf_pair_missing{
    .id = "SML3520",
    .name = "srdf-pair-missing",
    .severity = Severity::info,
    .summary = "Two links that a joint connects are checked for collisions with each other.",
    .remedy = "Disable the pair, unless the links must not touch.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3520_srdf_pair_missing_file
