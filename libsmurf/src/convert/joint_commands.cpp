// SPDX-License-Identifier: BSD-3-Clause
#include "convert/joint_commands.hpp"

#include "base/numbers/numbers.hpp"
#include "convert/import.hpp"

namespace smurf {
namespace {

/// 0 is the best; none for an interface that moves nothing, such as "gpio".
std::optional<int> rank_of(std::string_view interface) {
  if (interface == "position") return 0;
  if (interface == "velocity") return 1;
  if (interface == "effort") return 2;
  return std::nullopt;
}

/// Adds the limits that <param> states.
void add_limits(xml::View interface, JointCommand& command) {
  std::optional<double> min;
  std::optional<double> max;
  for (const xml::View param : interface) {
    const std::string_view name = attribute_of(param, "name");
    if (name == "min") min = parse_number(import::text_of(param));
    if (name == "max") max = parse_number(import::text_of(param));
  }
  const std::string_view name = attribute_of(interface, "name");
  if (name == "velocity") command.speed = max;
  if (name == "effort") command.effort = max;
  if (name != "position") return;
  command.position_lower = min;
  command.position_upper = max;
}

}  // namespace

std::optional<JointCommand> joint_command(xml::View joint, std::string_view preferred) {
  std::optional<JointCommand> command;
  const auto rank = [&](std::string_view interface) {
    return interface == preferred ? std::optional<int>(-1) : rank_of(interface);
  };
  for (const xml::View child : joint) {
    if (child.name() != "command_interface") continue;
    const std::string_view name = attribute_of(child, "name");
    if (!rank_of(name)) continue;
    if (!command) command.emplace(JointCommand{child, name, {}, {}, {}, {}});
    if (*rank(name) < *rank(command->interface)) {
      command->element = child;
      command->interface = name;
    }
    add_limits(child, *command);
  }
  return command;
}

std::optional<std::string_view> transmission_interface(xml::View transmission) {
  bool is_observed = false;
  for (const std::string_view part : {"joint", "actuator"}) {
    const xml::View parent = transmission.child(part);
    if (!parent) continue;
    for (const xml::View child : parent) {
      if (child.name() != "hardwareInterface") continue;
      const std::string_view interface = import::text_of(child);
      const bool is_state = interface.find("State") != std::string_view::npos;
      if (!is_state && !interface.empty()) return interface;
      is_observed = is_observed || is_state;
    }
  }
  if (is_observed) return std::nullopt;
  return "";
}

}  // namespace smurf
