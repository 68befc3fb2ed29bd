// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <string>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3241_submechanism_lists_disagree_file {
namespace {

void check_list(const LinkedModel& model, const Submechanism& mechanism, std::string_view key,
                const Field<NameList>& list, Findings& findings) {
  if (!list) return;
  std::set<std::string_view> all;
  for (const Spanned<std::string>& name : *mechanism.joint_names) all.insert(name.value);
  for (const Spanned<std::string>& name : *list) {
    // Unknown names are reported as possible misspellings.
    if (all.contains(name.value) || !model.joint_names.contains(name.value)) continue;
    Diagnostic& diagnostic = findings.report(
        name.span, quoted(key) + " of " + subject("submechanism", mechanism) + " contains " +
                       quoted(name.value) + ", which `jointnames` does not");
    diagnostic.label(mechanism.joint_names.span, "all joints of the mechanism");
  }
}

/// Unknown and repeated names are reported; they may be misspellings of the missing ones.
bool is_sound(const LinkedModel& model, const NameList& names) {
  std::set<std::string_view> seen;
  return std::all_of(names.begin(), names.end(), [&](const Spanned<std::string>& name) {
    return model.joint_names.contains(name.value) && seen.insert(name.value).second;
  });
}

void check(const LinkedModel& model, Findings& findings) {
  for (const Submechanism& mechanism : model.annotations.submechanisms) {
    if (!mechanism.joint_names || !is_sound(model, *mechanism.joint_names)) continue;
    check_list(model, mechanism, "jointnames_spanningtree", mechanism.joint_names_spanning_tree,
               findings);
    check_list(model, mechanism, "jointnames_active", mechanism.joint_names_active, findings);
    check_list(model, mechanism, "jointnames_independent", mechanism.joint_names_independent,
               findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::changes, "writes them for HyRoDyn unchecked",
     "Phobos io/hyrodyn.py"},
};

}  // namespace

extern constinit const Rule sml3241_submechanism_lists_disagree{
    .id = "SML3241",
    .name = "submechanism-lists-disagree",
    .severity = Severity::warning,
    .summary =
        "A list of a submechanism contains a joint that is not among the joints of the mechanism.",
    .why = "`jointnames` lists all joints of a submechanism, and the other lists choose from it: "
           "lists that disagree describe no mechanism.",
    .remedy = "Add the joint to `jointnames`, or delete it from the other list.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3241_submechanism_lists_disagree_file
