// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const std::vector<urdf::Link>& all = model.robot->links;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].name || all[i].name->empty()) continue;
    const auto first = model.link_names.find(*all[i].name);
    if (*first == i) continue;
    Diagnostic& diagnostic =
        findings.report(all[i].name.span, "a second link is named " + quoted(*all[i].name));
    diagnostic.label(all[*first].name.span, "the first one");
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file", "urdfdom, sdformat, MuJoCo, Bullet, run"},
};

}  // namespace

extern constinit const Rule sml1301_duplicate_link{
    .id = "SML1301",
    .name = "duplicate-link",
    .severity = Severity::error,
    .summary = "Two links have the same name.",
    .why = "urdf-loader uses the last one.",
    .remedy = "Rename one of them, with everything that refers to it.",
    .sources = "urdf-loader 0.13, executed.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules
