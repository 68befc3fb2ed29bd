// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <map>
#include <set>
#include <string_view>
#include <vector>

#include "lint/companions/controllers.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3708_controller_chain_file {
namespace {

constexpr Circumstance kUnknown{"unknown"};
constexpr Circumstance kHumble{"chainable later"};

/// The controllers of all files of the robot.
struct All {
  std::vector<RosController> controllers;
  std::vector<std::string_view> names;
  std::map<std::string_view, std::size_t> numbers;  ///< the first of each name

  explicit All(const Companions& companions) {
    for_each_controller_file(companions, [&](const ControllerFile& file) {
      controllers.insert(controllers.end(), file.controllers.begin(), file.controllers.end());
    });
    for (std::size_t i = 0; i < controllers.size(); ++i) {
      names.push_back(controllers[i].name);
      numbers.try_emplace(names.back(), i);
    }
  }

  const RosController* find(std::string_view name) const {
    const auto found = numbers.find(name);
    return found == numbers.end() ? nullptr : &controllers[found->second];
  }
};

void report_unknown(const All& all, const RosController& controller, yaml::View value,
                    std::string_view name, Findings& findings) {
  // It may be a sensor or a part of hardware.
  const auto near = findings.suggest(name, all.names);
  if (!near || *near == controller.name) return;
  findings
      .report(value.span(), title_of(controller) + " commands " + quoted(value.text()) +
                                ", but there is no controller " + quoted(name))
      .help("did you mean " + quoted(*near) + "?")
      .when(kUnknown);
}

void check_name(const All& all, const RosController& controller, yaml::View value,
                Findings& findings) {
  const std::string_view text = value.text();
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos || slash == 0 || is_placeholder(text)) return;
  const std::string_view name = text.substr(0, slash);
  const RosController* other = all.find(name);
  if (other == nullptr) return report_unknown(all, controller, value, name, findings);
  if (other->known == nullptr || other->known->chainable == other->known->distributions) return;
  const bool is_never = other->known->chainable.empty();
  Diagnostic& found = findings.report(
      value.span(),
      title_of(controller) + " commands " + quoted(text) + ", but " + quoted(other->known->name) +
          (is_never ? std::string(" is not chainable")
                    : " is chainable in " + distribution_names(other->known->chainable) + " only"));
  found.label(other->place, "the controller is declared here");
  if (!is_never) {
    found.severity = Severity::warning;
    found.when(kHumble);
  }
  found.help("command the interface of the hardware, or use a chainable controller");
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  const All all(companions);
  for (const RosController& one : all.controllers) {
    const std::string_view key = one.list("command_joints").empty() ? "joints" : "command_joints";
    if (one.known == nullptr || one.list("command_interfaces").empty()) continue;
    std::set<std::string_view> seen;  // one finding for each of the others
    for (const yaml::View value : one.list(key)) {
      const std::string_view other = value.text().substr(0, value.text().find('/'));
      if (seen.insert(other).second) check_name(all, one, value, findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not activate the controller, unless another program offers it",
     "ros2_control controller_manager.cpp", when(kUnknown)},
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not activate the controller", "ros2_control controller_manager.cpp",
     when(kHumble).before(kParserOfJazzy)},
    {&readers::ros2_control, Effect::takes, "chains the controllers",
     "ros2_control controller_manager.cpp", when(kHumble)},
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not activate the controller",
     "ros2_control controller_manager.cpp"},
};

}  // namespace

extern constinit const Rule sml3708_controller_chain{
    .id = "SML3708",
    .name = "controller-chain",
    .severity = Severity::error,
    .summary = "A controller commands another one that does not exist or is not chainable.",
    .remedy = "Name a chainable controller, such as a PidController.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3708_controller_chain_file
