// SPDX-License-Identifier: BSD-3-Clause
#include <map>

#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3508_srdf_group_twice_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    std::map<std::string_view, Span> known;
    for (const srdf::Group& group : srdf.groups) {
      if (!group.name) continue;
      const auto [first, is_new] = known.emplace(*group.name, group.name.span);
      if (is_new) continue;
      findings
          .report(place_of(srdf, group.name, group.element),
                  "there is a group " + quoted(*group.name) + " already")
          .label(first->second, "the first group is here")
          .help("rename one of them, or put all members into one group");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "warns and uses the first group only",
     "moveit2 robot_model.cpp addJointModelGroup"},
};

}  // namespace

extern constinit const Rule sml3508_srdf_group_twice{
    .id = "SML3508",
    .name = "srdf-group-twice",
    .severity = Severity::error,
    .summary = "Two groups of an SRDF have the same name.",
    .remedy = "Rename one of them, or put all members into one group.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3508_srdf_group_twice_file
