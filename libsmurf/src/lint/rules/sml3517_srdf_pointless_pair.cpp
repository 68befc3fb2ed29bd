// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <tuple>

#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3517_srdf_pointless_pair_file {
namespace {

Diagnostic& report(const srdf::Description& srdf, const srdf::LinkPair& pair, std::string message,
                   Findings& findings) {
  const xml::View element(srdf.document, pair.element);
  Diagnostic& found = findings.report(element.name_span(), std::move(message));
  found.help("delete it");
  found.fixes.push_back({Applicability::safe, {{element.span(), ""}}});
  return found;
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    std::map<std::tuple<bool, std::string_view, std::string_view>, const srdf::LinkPair*> known;
    for (const srdf::LinkPair& pair : srdf.pairs) {
      if (!pair.link1 || !pair.link2) continue;
      std::string_view a = *pair.link1, b = *pair.link2;
      if (a == b) {
        report(srdf, pair, "this pair names the link " + quoted(a) + " twice", findings);
        continue;
      }
      if (b < a) std::swap(a, b);
      const auto [first, is_new] = known.emplace(std::tuple(pair.is_enabled, a, b), &pair);
      if (is_new) continue;
      report(srdf, pair, "the pair of " + quoted(a) + " and " + quoted(b) + " is here again",
             findings)
          .label(tag_of(srdf, first->second->element), "it is first here");
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::takes, "loads the robot as if it were not there",
     "srdfdom model.cpp loadCollisionPairs"},
};

}  // namespace

extern constinit const Rule sml3517_srdf_pointless_pair{
    .id = "SML3517",
    .name = "srdf-pointless-pair",
    .severity = Severity::info,
    .summary = "A pair of links is repeated, or both links are the same.",
    .remedy = "Delete the pair.",
    .facts = kFacts};

}  // namespace smurf::rules::sml3517_srdf_pointless_pair_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3517_srdf_pointless_pair =
    rules::sml3517_srdf_pointless_pair_file::check;

}  // namespace smurf::companion_checks
