// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3810_moveit_value_file {
namespace {

constexpr Circumstance kSolver{"solver"};

/// Whether a number meets a condition.
bool meets(double number, const ValueCondition& condition) {
  using Kind = ValueCondition::Kind;
  switch (condition.kind) {
  case Kind::above: return number > condition.bound;
  case Kind::at_least: return number >= condition.bound;
  case Kind::below: return number < condition.bound;
  case Kind::at_most: return number <= condition.bound;
  default: return true;
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_moveit_value(companions, [&](const Companion& file, const RosParameter& parameter,
                                        yaml::View value, const std::string& path) {
    const auto number = value.is_scalar() ? value.number() : std::nullopt;
    if (!number) return;
    for (const ValueCondition& one : conditions_of(parameter)) {
      if (meets(*number, one)) continue;
      Diagnostic& found =
          findings.report(value.span(), quoted(path) + " is " + quoted(value.text()) +
                                            ", but must be " + describe(one));
      if (file.kind == CompanionKind::kinematics) found.when(kSolver);
      found.help("write a number that is " + describe(one));
      return;
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::crashes, "move_group and RViz end with an exception",
     "moveit2 kinematics_parameters.yaml, validation; from Iron on", when(kSolver)},
    {&readers::moveit, Effect::changes, "plans with the wrong limit, or uses its default",
     "moveit2 robot_model_loader.cpp, time_optimal_trajectory_generation.cpp"},
};

}  // namespace

extern constinit const Rule sml3810_moveit_value{
    .id = "SML3810",
    .name = "moveit-value",
    .severity = Severity::warning,
    .summary = "A number in a parameter file of MoveIt is outside of what MoveIt accepts.",
    .remedy = "Write a number within the bounds.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3810_moveit_value_file
