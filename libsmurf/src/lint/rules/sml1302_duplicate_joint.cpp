// SPDX-License-Identifier: BSD-3-Clause
#include "base/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  const std::vector<urdf::Joint>& all = model.robot->joints;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!all[i].name || all[i].name->empty()) continue;
    const auto first = model.joint_names.find(*all[i].name);
    if (*first == i) continue;
    Diagnostic& diagnostic =
        findings.report(all[i].name.span, "a second joint is named " + quoted(*all[i].name));
    diagnostic.label(all[*first].name.span, "the first one");
  }
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::refuses, "refuses the file", "urdfdom, sdformat, Bullet, run"},
    {&readers::mujoco, Effect::takes, "accepts joints of equal names", kRun},
};

}  // namespace

extern constinit const Rule sml1302_duplicate_joint{
    .id = "SML1302",
    .name = "duplicate-joint",
    .severity = Severity::error,
    .summary = "Two joints have the same name.",
    .why = "urdf-loader uses the last one.",
    .remedy = "Rename one of them, with everything that refers to it.",
    .sources = "urdf-loader 0.13, executed.",
    .check_model = check,
    .facts = kFacts,
    .blocks_building = true};

}  // namespace smurf::rules
