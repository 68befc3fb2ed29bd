// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <string_view>
#include <vector>

#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3807_moveit_planner_file {
namespace {

void check_name(yaml::View value, const std::vector<std::string_view>& known,
                const std::set<std::string_view>& names, Findings& findings) {
  if (!value.is_scalar() || value.text().empty() || names.contains(value.text())) return;
  Diagnostic& found =
      findings.report(value.span(), "`planner_configs` has no planner " + quoted(value.text()));
  if (const auto near = findings.suggest(value.text(), known)) {
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
    std::vector<std::string_view> known;
    for (const yaml::View one : definitions) known.push_back(one.key());
    const std::set<std::string_view> names(known.begin(), known.end());
    for (const yaml::View group : root) {
      if (!group.is_mapping() || group.is_repeated()) continue;
      const yaml::View planners = group.find("planner_configs");
      if (!planners || !planners.is_sequence()) continue;
      for (const yaml::View one : planners) check_name(one, known, names, findings);
      const yaml::View usual = group.find("default_planner_config");
      // The Setup Assistant writes None, with which MoveIt uses its own default.
      if (usual && usual.text() != "None") check_name(usual, known, names, findings);
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
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3807_moveit_planner_file
