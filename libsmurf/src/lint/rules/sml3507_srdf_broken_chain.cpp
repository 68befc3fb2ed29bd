// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3507_srdf_broken_chain_file {
namespace {

constexpr Circumstance kSwapped{"swapped"};

void check_chain(const LinkedModel& model, const srdf::Description& srdf, const srdf::Group& group,
                 const srdf::Member& chain, Findings& findings) {
  if (!chain.base || !chain.tip) return;
  if (model.find_link(*chain.base) == nullptr || model.find_link(*chain.tip) == nullptr) return;
  const Chain found = chain_between(model, *chain.base, *chain.tip);
  const std::string ends = quoted(*chain.base) + " and " + quoted(*chain.tip);
  if (!found.is_joined) {
    findings
        .report(tag_of(srdf, chain.element), "no joints lead from " + ends +
                                                 ", the ends of a "
                                                 "chain of " +
                                                 title_of("group", group.name))
        .help("write two links of which one is above the other");
    return;
  }
  const Chain back = chain_between(model, *chain.tip, *chain.base);
  if (found.is_below || !back.is_below) return;
  Diagnostic& swapped = findings.report(
      tag_of(srdf, chain.element), "the chain of " + title_of("group", group.name) +
                                       " has its ends the wrong way round: " + quoted(*chain.base) +
                                       " is below " + quoted(*chain.tip));
  swapped.severity = Severity::warning;
  swapped.when(kSwapped);
  swapped.help("swap base_link and tip_link");
  swapped.fixes.push_back(
      {Applicability::unsafe, {{chain.base.span, *chain.tip}, {chain.tip.span, *chain.base}}});
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (!model.robot) return;
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::Group& group : srdf.groups) {
      for (const srdf::Member& member : group.members) {
        if (member.kind == srdf::Member::Kind::chain) {
          check_chain(model, srdf, group, member, findings);
        }
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::changes,
     "takes the joints between them, but no solver finds a pose of the tip",
     "srdfdom model.cpp loadGroups; moveit2 robot_model.cpp addJointModelGroup", when(kSwapped)},
    {&readers::moveit, Effect::breaks, "reports an error and drops the chain from the group",
     "srdfdom model.cpp loadGroups"},
};

}  // namespace

extern constinit const Rule sml3507_srdf_broken_chain{
    .id = "SML3507",
    .name = "srdf-broken-chain",
    .severity = Severity::error,
    .summary = "The ends of a chain are not connected, or the tip is above the base.",
    .remedy = "Write a base link and a tip link below it.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3507_srdf_broken_chain_file
