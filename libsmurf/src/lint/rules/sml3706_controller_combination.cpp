// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <string_view>

#include "lint/companions/trajectory.hpp"

namespace smurf::rules::sml3706_controller_combination_file {
namespace {

constexpr Circumstance kGains{"gains"};

using Names = std::set<std::string_view>;

std::string_view why_not_states(const Names& states) {
  if (states.contains("velocity") && !states.contains("position")) {
    return "`velocity` needs `position`";
  }
  const bool has_both = states.contains("velocity") && states.contains("position");
  if (states.contains("acceleration") && !has_both) {
    return "`acceleration` needs `position` and `velocity`";
  }
  return {};
}

void report(const RosController& controller, std::string_view key, std::string_view why,
            Findings& findings) {
  findings
      .report(controller.parameter(key).span(),
              "the " + quoted(key) + " of " + title_of(controller) + " do not go together")
      .help(std::string(why));
}

void check_gains(const RosController& controller, const Names& commands, Findings& findings) {
  const bool needs_gains =
      commands.size() == 1 && (commands.contains("velocity") || commands.contains("effort"));
  if (!needs_gains || controller.list("joints").empty()) return;
  const yaml::View gains = controller.parameter("gains");
  if (gains && !gains.is_mapping()) return;
  std::string missing;
  for (const yaml::View joint : controller.list("joints")) {
    if (is_placeholder(joint.text())) return;
    if (gains && gains.find(joint.text())) continue;
    missing += (missing.empty() ? "" : ", ") + quoted(joint.text());
  }
  if (missing.empty()) return;
  Diagnostic& found =
      findings.report(controller.parameter("command_interfaces").span(),
                      title_of(controller) + " commands " + quoted(*commands.begin()) +
                          " without gains for " + shortened(missing, 200));
  found.severity = Severity::warning;
  found.when(kGains);
  found.help("write `gains` with `p`, `i` and `d` for each joint");
}

void check_controller(const RosController& controller, Findings& findings) {
  const Names commands = names_in(controller, "command_interfaces");
  const Names states = names_in(controller, "state_interfaces");
  const std::string_view why = why_not_together(commands);
  if (!why.empty()) report(controller, "command_interfaces", why, findings);
  const std::string_view why_states = why_not_states(states);
  if (!why_states.empty()) report(controller, "state_interfaces", why_states, findings);
  if (!why.empty() || !why_states.empty()) return;
  const bool is_closed_loop =
      (commands.size() == 1 && commands.contains("velocity")) || commands.contains("effort");
  const bool has_states = states.contains("position") && states.contains("velocity");
  if (is_closed_loop && !states.empty() && !has_states) {
    report(controller, "state_interfaces",
           "with these command interfaces, it needs the states `position` and `velocity`",
           findings);
    return;
  }
  check_gains(controller, commands, findings);
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) {
      if (is_trajectory_controller(one) && one.section) check_controller(one, findings);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::changes, "uses zero gains: the joints do not move",
     "ros2_controllers joint_trajectory_controller.cpp", when(kGains)},
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not configure the controller",
     "ros2_controllers validate_jtc_parameters.hpp, joint_trajectory_controller.cpp on_configure"},
};

}  // namespace

extern constinit const Rule sml3706_controller_combination{
    .id = "SML3706",
    .name = "controller-combination",
    .severity = Severity::error,
    .summary = "A trajectory controller has interfaces that cannot be used together.",
    .remedy = "Use position alone or with velocity, velocity alone, or effort alone.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3706_controller_combination_file
