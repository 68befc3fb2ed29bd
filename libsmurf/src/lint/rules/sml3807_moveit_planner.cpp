// SPDX-License-Identifier: BSD-3-Clause
#include <vector>

#include "base/text/suggest.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3807_moveit_planner_file {
namespace {

void check_name(yaml::View value, yaml::View definitions, Findings& findings) {
  if (!value.is_scalar() || value.text().empty() || definitions.find(value.text())) return;
  std::vector<std::string_view> known;
  for (const yaml::View one : definitions) known.push_back(one.key());
  Diagnostic& found =
      findings.report(value.span(), "`planner_configs` has no planner " + quoted(value.text()));
  if (const auto near = only_nearest(value.text(), known)) {
    found.help("did you mean " + quoted(*near) + "?");
    found.fixes.push_back({Applicability::unsafe, {{value.span(), std::string(*near)}}});
  } else {
    found.help("define it below `planner_configs`, or delete it here");
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_file(companions, CompanionKind::ompl_planning, [&](const Companion&, yaml::View root) {
    const yaml::View definitions = root.find("planner_configs");
    if (!definitions || !definitions.is_mapping()) return;
    for (const yaml::View group : root) {
      if (!group.is_mapping() || group.is_repeated()) continue;
      const yaml::View planners = group.find("planner_configs");
      if (!planners || !planners.is_sequence()) continue;
      for (const yaml::View one : planners) check_name(one, definitions, findings);
      const yaml::View usual = group.find("default_planner_config");
      // The Setup Assistant writes None, with which MoveIt uses its own default.
      if (usual && usual.text() != "None") check_name(usual, definitions, findings);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::loses, "reports an error and does not offer the planner",
     "moveit2 ompl_interface.cpp loadPlannerConfiguration"},
};

}  // namespace

extern constinit const Rule sml3807_moveit_planner{
    .id = "SML3807",
    .name = "moveit-planner",
    .severity = Severity::warning,
    .summary = "A group in ompl_planning.yaml uses a planner that the file does not define.",
    .remedy = "Correct the name, or define the planner below `planner_configs`.",
    .facts = kFacts};

}  // namespace smurf::rules::sml3807_moveit_planner_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3807_moveit_planner =
    rules::sml3807_moveit_planner_file::check;

}  // namespace smurf::companion_checks
