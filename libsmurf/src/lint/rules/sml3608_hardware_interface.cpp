// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/text/suggest.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3608_hardware_interface_file {
namespace {

constexpr Circumstance kNoState{"no state"};
constexpr Circumstance kTwice{"twice"};

constexpr std::array<std::string_view, 4> kStandard = {"position", "velocity", "effort",
                                                       "acceleration"};

void check_name(const HardwareInterface& one, const std::string& title, Findings& findings) {
  if (std::find(kStandard.begin(), kStandard.end(), one.name) != kStandard.end()) return;
  // `position_pid` of gazebo_ros2_control is a name of its own.
  const bool is_longer =
      std::any_of(kStandard.begin(), kStandard.end(), [&](std::string_view word) {
        return one.name.starts_with(std::string(word) + "_") ||
               one.name.ends_with("_" + std::string(word));
      });
  const auto near = is_longer ? std::nullopt : only_nearest(one.name, kStandard);
  if (!near) return;
  const Span place = place_of(one.element, "name");
  Diagnostic& found = findings.report(place, title + " has an interface " + quoted(one.name) +
                                                 ", which no controller asks for");
  found.help("did you mean " + quoted(*near) + "?");
  found.fixes.push_back({Applicability::unsafe, {{place, std::string(*near)}}});
}

void check_part(const HardwarePart& part, const std::string& title, Findings& findings) {
  std::set<std::pair<bool, std::string_view>> seen;
  for (const HardwareInterface& one : part.interfaces) {
    if (one.name.empty()) continue;
    if (!seen.insert({one.is_command, one.name}).second) {
      findings
          .report(place_of(one.element, "name"), title + " has the " +
                                                     std::string(one.element.name()) + " " +
                                                     quoted(one.name) + " twice")
          .help("delete one of them")
          .when(kTwice);
    } else if (part.is_joint()) {
      check_name(one, title, findings);
    }
  }
  const bool has_state = seen.lower_bound({false, ""}) != seen.lower_bound({true, ""});
  if (part.is_joint() && part.has_command() && !has_state) {
    findings
        .report(place_of(part.element, "name"), title + " is commanded, but has no state interface")
        .help("add `<state_interface name=\"position\"/>`: most controllers need it")
        .when(kNoState);
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& hardware : hardware_of(model)) {
    for (const HardwarePart& part : hardware.parts) {
      check_part(part, title_of(part, hardware), findings);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::changes, "uses one of them and warns about the other",
     "ros2_control hardware_interface/src/resource_manager.cpp", when(kTwice)},
    {&readers::ros2_control, Effect::changes,
     "loads the joint; joint_state_broadcaster and most controllers do not see it",
     "ros2_control hardware_interface/src/resource_manager.cpp", when(kNoState)},
    {&readers::ros2_control, Effect::changes, "exports it under that name",
     "ros2_control hardware_interface/src/component_parser.cpp"},
};

}  // namespace

extern constinit const Rule sml3608_hardware_interface{
    .id = "SML3608",
    .name = "hardware-interface",
    .severity = Severity::warning,
    .summary = "An interface of a joint is misspelt, repeated, or a state interface is missing.",
    .why = "Controllers that ask for the interface cannot be activated.",
    .remedy = "Write position, velocity, effort or acceleration, each once.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3608_hardware_interface_file
