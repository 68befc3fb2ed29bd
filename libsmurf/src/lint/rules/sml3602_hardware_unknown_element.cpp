// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <span>

#include "base/suggest.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3602_hardware_unknown_element_file {
namespace {

constexpr Circumstance kInner{"inner"};

/// The children that the parser reads of an element. It ignores others, except in `ros2_control`.
struct Children {
  std::string_view parent;
  std::span<const std::string_view> names;
};
constexpr std::string_view kOfControl[] = {"hardware", "joint",        "sensor",
                                           "gpio",     "transmission", "properties"};
constexpr std::string_view kOfHardware[] = {"plugin", "param", "group"};
constexpr std::string_view kOfJoint[] = {"command_interface", "state_interface", "param", "limits"};
constexpr std::string_view kOfSensor[] = {"state_interface", "command_interface", "param",
                                          "limits"};
constexpr std::string_view kOfInterface[] = {"param", "limits"};
constexpr std::string_view kOfTransmission[] = {"plugin", "joint", "actuator", "param"};
constexpr Children kChildren[] = {
    {"hardware", kOfHardware},
    {"joint", kOfJoint},
    {"sensor", kOfSensor},
    {"gpio", kOfSensor},
    {"command_interface", kOfInterface},
    {"state_interface", kOfInterface},
    {"transmission", kOfTransmission},
};

void check_children(xml::View element, Findings& findings) {
  const auto row = std::find_if(std::begin(kChildren), std::end(kChildren),
                                [&](const auto& one) { return one.parent == element.name(); });
  if (row == std::end(kChildren)) return;
  for (const xml::View child : element) {
    const bool is_known =
        std::find(row->names.begin(), row->names.end(), child.name()) != row->names.end();
    if (is_known) {
      if (element.name() != "transmission") check_children(child, findings);
      continue;
    }
    // A misspelt plugin has its own finding.
    const auto near = only_nearest(child.name(), row->names);
    if (!near || *near == "plugin") continue;
    Diagnostic& found =
        findings.report(child.name_span(), "ros2_control does not read " + quoted(child.name()) +
                                               " in " + quoted(element.name()));
    found.severity = Severity::warning;
    found.when(kInner);
    found.help("did you mean " + quoted(*near) + "?");
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& one : hardware_of(model)) {
    for (const xml::View child : one.element) {
      if (std::find(std::begin(kOfControl), std::end(kOfControl), child.name()) !=
          std::end(kOfControl)) {
        check_children(child, findings);
        continue;
      }
      Diagnostic& found =
          findings.report(child.name_span(),
                          title_of(one) + " contains the unknown element " + quoted(child.name()));
      const auto near = only_nearest(child.name(), kOfControl);
      found.help(near ? "did you mean " + quoted(*near) + "?"
                      : "delete it, or move it out of `ros2_control`");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::loses, "ignores it without a message",
     "ros2_control hardware_interface/src/component_parser.cpp", when(kInner)},
    no_hardware(),
    {&readers::ros, Effect::loses, "ros2_control ignores it without a message",
     "ros2_control hardware_interface/src/component_parser.cpp", when(kInner)},
    no_hardware_in_ros()};

}  // namespace

extern constinit const Rule sml3602_hardware_unknown_element{
    .id = "SML3602",
    .name = "hardware-unknown-element",
    .severity = Severity::error,
    .summary = "An element in `ros2_control` is not one that it reads there.",
    .remedy = "Correct the name of the element, or delete it.",
    .facts = kFacts};

}  // namespace smurf::rules::sml3602_hardware_unknown_element_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3602_hardware_unknown_element =
    rules::sml3602_hardware_unknown_element_file::check;

}  // namespace smurf::companion_checks
