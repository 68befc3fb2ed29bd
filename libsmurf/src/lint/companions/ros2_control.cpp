// SPDX-License-Identifier: BSD-3-Clause
// Source: ros2_control hardware_interface/src/component_parser.cpp (53b9999).
#include "lint/companions/ros2_control.hpp"

#include <algorithm>

#include "base/text/words.hpp"

namespace smurf {
namespace {

HardwarePart read_part(xml::View element) {
  HardwarePart part{element, attribute_text(element, "name"), {}};
  for (const xml::View child : element) {
    const bool is_command = child.name() == "command_interface";
    if (!is_command && child.name() != "state_interface") continue;
    part.interfaces.push_back({child, is_command, attribute_text(child, "name")});
  }
  return part;
}

}  // namespace

xml::View HardwareInterface::parameter_element(std::string_view wanted) const {
  for (const xml::View child : element) {
    if (child.name() == "param" && attribute_text(child, "name") == wanted) return child;
  }
  return {};
}

std::optional<std::string_view> HardwareInterface::parameter(std::string_view wanted) const {
  const xml::View found = parameter_element(wanted);
  return found ? std::optional(trimmed(found.text())) : std::nullopt;
}

bool HardwarePart::has_command() const {
  return std::any_of(interfaces.begin(), interfaces.end(),
                     [](const HardwareInterface& one) { return one.is_command; });
}

bool HardwarePart::has(std::string_view interface, bool is_command) const {
  return std::any_of(interfaces.begin(), interfaces.end(), [&](const HardwareInterface& one) {
    return one.name == interface && one.is_command == is_command;
  });
}

const HardwarePart* Hardware::find_joint(std::string_view wanted) const {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const HardwarePart& one) {
    return one.is_joint() && one.name == wanted;
  });
  return found == parts.end() ? nullptr : &*found;
}

std::vector<Hardware> hardware_of(const LinkedModel& model) {
  std::vector<Hardware> all;
  if (!model.robot) return all;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View element(model.robot->document, id);
    if (element.name() != "ros2_control") continue;
    Hardware& one = all.emplace_back(
        Hardware{element, attribute_text(element, "name"), attribute_text(element, "type"), {}});
    for (const xml::View child : element) {
      if (is_one_of(child.name(), {"joint", "sensor", "gpio"})) {
        one.parts.push_back(read_part(child));
      }
    }
  }
  return all;
}

std::string_view attribute_text(xml::View element, std::string_view name) {
  const xml::Attribute* attribute = element.attribute(name);
  return attribute == nullptr ? std::string_view() : trimmed(attribute->value());
}

Span place_of(xml::View element, std::string_view attribute) {
  const xml::Attribute* found = element.attribute(attribute);
  return found == nullptr || found->value_span().empty() ? element.name_span()
                                                         : found->value_span();
}

std::string title_of(const Hardware& hardware) {
  return hardware.name.empty() ? "this ros2_control" : "ros2_control " + quoted(hardware.name);
}

std::string title_of(const HardwarePart& part, const Hardware& hardware) {
  const std::string kind(part.element.name());
  return (part.name.empty() ? "a " + kind : kind + " " + quoted(part.name)) + " of " +
         title_of(hardware);
}

}  // namespace smurf
