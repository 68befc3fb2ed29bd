// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3509_srdf_group_cycle_file {
namespace {

/// Whether `wanted` is in `group`, at any depth.
bool holds(const srdf::Description& srdf, const srdf::Group& group, const srdf::Group& wanted,
           std::set<const srdf::Group*>& seen) {
  if (!seen.insert(&group).second) return false;
  for (const srdf::Member& member : group.members) {
    if (member.kind != srdf::Member::Kind::group || !member.name) continue;
    const srdf::Group* inner = srdf.find_group(*member.name);
    if (inner == nullptr) continue;
    if (inner == &wanted || holds(srdf, *inner, wanted, seen)) return true;
  }
  return false;
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    std::set<const srdf::Group*> reported;
    for (const srdf::Group& group : srdf.groups) {
      std::set<const srdf::Group*> seen;
      if (!holds(srdf, group, group, seen)) continue;
      // All groups of a ring have the same fault.
      bool is_known = false;
      for (const srdf::Group* other : reported) is_known = is_known || seen.contains(other);
      if (!is_known) {
        findings
            .report(place_of(srdf, group.name, group.element),
                    title_of("group", group.name) + " contains itself")
            .help("remove one of the groups in it");
      }
      reported.insert(&group);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and drops all groups of the ring",
     "srdfdom model.cpp loadGroups"},
};

}  // namespace

extern constinit const Rule sml3509_srdf_group_cycle{.id = "SML3509",
                                                     .name = "srdf-group-cycle",
                                                     .severity = Severity::error,
                                                     .summary =
                                                         "A group of an SRDF contains itself.",
                                                     .remedy = "Remove one of the groups in it.",
                                                     .facts = kFacts};

}  // namespace smurf::rules::sml3509_srdf_group_cycle_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3509_srdf_group_cycle =
    rules::sml3509_srdf_group_cycle_file::check;

}  // namespace smurf::companion_checks
