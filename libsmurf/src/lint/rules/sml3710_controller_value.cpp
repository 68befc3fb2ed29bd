// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <string>

#include "base/numbers/numbers.hpp"
#include "lint/companions/trajectory.hpp"

namespace smurf::rules::sml3710_controller_value_file {
namespace {

constexpr Circumstance kSubset{"subset"};

/// Why a number or a text does not meet a condition.
bool meets(yaml::View value, const ValueCondition& condition) {
  using Kind = ValueCondition::Kind;
  if (condition.kind == Kind::one_of) {
    return std::find(condition.texts.begin(), condition.texts.end(), value.text()) !=
           condition.texts.end();
  }
  const auto number = value.number();
  if (!number) return true;
  switch (condition.kind) {
  case Kind::above: return *number > condition.bound;
  case Kind::at_least: return *number >= condition.bound;
  case Kind::below: return *number < condition.bound;
  case Kind::at_most: return *number <= condition.bound;
  default: return true;
  }
}

void report(yaml::View value, const std::string& subject, const std::string& wanted,
            Findings& findings) {
  findings.report(value.span(), subject + " is " + quoted(value.text()) + ", but must be " + wanted)
      .help("write a value that is " + wanted);
}

void check_list(yaml::View value, const std::string& subject, const ValueCondition& condition,
                Findings& findings) {
  using Kind = ValueCondition::Kind;
  if (condition.kind == Kind::size) {
    if (value.size() == static_cast<std::size_t>(condition.bound)) return;
    findings
        .report(value.place(), subject + " has " + std::to_string(value.size()) +
                                   " values, but must have " + describe(condition))
        .help("write " + describe(condition));
    return;
  }
  std::set<std::string_view> seen;
  for (const yaml::View item : value) {
    if (!item.is_scalar() || is_placeholder(item.text())) continue;
    if (condition.kind == Kind::unique) {
      if (seen.insert(item.text()).second) continue;
      findings.report(item.span(), subject + " contains " + quoted(item.text()) + " twice")
          .help("delete one of them");
      return;
    }
    if (meets(item, condition)) continue;
    return report(item, "a value in " + subject, describe(condition), findings);
  }
}

void check_value(yaml::View value, const std::string& subject, const RosParameter& parameter,
                 Findings& findings) {
  for (const ValueCondition& one : conditions_of(parameter)) {
    if (value.is_sequence()) {
      check_list(value, subject, one, findings);
    } else if (value.is_scalar() && !value.text().empty() && !is_placeholder(value.text()) &&
               !meets(value, one)) {
      return report(value, subject, describe(one), findings);
    }
  }
}

/// Fewer `command_joints` than `joints` must be some of them; as many may be those of another
/// controller.
void check_commanded(const LinkedModel& model, const RosController& controller,
                     Findings& findings) {
  if (!is_trajectory_controller(controller)) return;
  const std::vector<yaml::View> commanded = controller.list("command_joints");
  const std::size_t joints = controller.list("joints").size();
  if (joints == 0 || commanded.empty() || commanded.size() == joints) return;
  if (commanded.size() > joints) {
    findings
        .report(controller.parameter("command_joints").place(),
                title_of(controller) + " has more `command_joints` than `joints`")
        .help("write at most as many `command_joints` as `joints`")
        .when(kSubset);
    return;
  }
  const std::set<std::string_view> known = names_in(controller, "joints");
  if (std::any_of(known.begin(), known.end(), is_placeholder)) return;
  for (const yaml::View one : commanded) {
    if (known.contains(one.text()) || is_placeholder(one.text())) continue;
    const bool is_chained = one.text().find('/') != std::string_view::npos;
    if (!is_chained && !model.joint_index(one.text())) continue;  // SML3701
    Diagnostic& found =
        findings.report(one.span(), title_of(controller) + " commands " + quoted(one.text()) +
                                        ", which is not one of its `joints`");
    const auto near = findings.suggest(one.text(), std::vector(known.begin(), known.end()));
    found.help(near ? "did you mean " + quoted(*near) + "?"
                    : "write some of the `joints`, or as many `command_joints` as `joints`");
    found.when(kSubset);
    return;
  }
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for_each_known_controller(
      companions, [&](const RosController& controller, const std::vector<RosParameter>& known) {
        for_each_parameter(
            controller.section, known,
            [&](yaml::View value, const std::string& path, const RosParameter& parameter) {
              check_value(value, quoted(path) + " of " + title_of(controller), parameter, findings);
            });
        check_commanded(model, controller, findings);
      });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not configure the controller",
     "ros2_controllers joint_trajectory_controller.cpp on_configure", when(kSubset)},
    {&readers::ros2_control, Effect::breaks, "reports an error and does not load the controller",
     "ros2_controllers *_parameters.yaml, validation"},
};

}  // namespace

extern constinit const Rule sml3710_controller_value{
    .id = "SML3710",
    .name = "controller-value",
    .severity = Severity::error,
    .summary = "A parameter of a controller has a value that the controller does not accept.",
    .remedy = "Write a value within the bounds of the parameter.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3710_controller_value_file
