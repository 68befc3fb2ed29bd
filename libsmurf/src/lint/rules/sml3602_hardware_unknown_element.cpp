// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <span>

#include "base/text/suggest.hpp"
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
constexpr std::string_view kOfProperties[] = {"async"};
constexpr std::string_view kOfGear[] = {"mechanical_reduction", "offset"};
constexpr Children kChildren[] = {
    {"hardware", kOfHardware},
    {"joint", kOfJoint},
    {"sensor", kOfSensor},
    {"gpio", kOfSensor},
    {"command_interface", kOfInterface},
    {"state_interface", kOfInterface},
    {"transmission", kOfTransmission},
    {"transmission/joint", kOfGear},
    {"transmission/actuator", kOfGear},
    {"properties", kOfProperties},
};

/// The attributes that the parser reads.
constexpr std::string_view kOfControlTag[] = {"name", "type", "rw_rate", "is_async",
                                              "thread_priority"};
constexpr std::string_view kOfJointTag[] = {"name", "mimic"};
constexpr std::string_view kOfInterfaceTag[] = {"name", "data_type", "size"};
constexpr std::string_view kOfLimitsTag[] = {"enable"};
constexpr std::string_view kOfAsyncTag[] = {"affinity", "scheduling_policy", "thread_priority",
                                            "print_warnings"};
constexpr std::string_view kOfGearTag[] = {"name", "role", "read_only"};
constexpr Children kAttributes[] = {
    {"ros2_control", kOfControlTag},
    {"joint", kOfJointTag},
    {"command_interface", kOfInterfaceTag},
    {"state_interface", kOfInterfaceTag},
    {"limits", kOfLimitsTag},
    {"async", kOfAsyncTag},
    {"transmission/joint", kOfGearTag},
    {"transmission/actuator", kOfGearTag},
};

const Children* find_row(std::span<const Children> rows, xml::View element) {
  const bool is_gear = element.parent().name() == "transmission";
  const std::string name = (is_gear ? "transmission/" : "") + std::string(element.name());
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const auto& one) { return one.parent == name; });
  return row == rows.end() ? nullptr : &*row;
}

bool holds(std::span<const std::string_view> names, std::string_view wanted) {
  return std::find(names.begin(), names.end(), wanted) != names.end();
}

/// Whether the parser reads an element of this name anywhere.
bool is_read_elsewhere(std::string_view name) {
  return holds(kOfControl, name) ||
         std::any_of(std::begin(kChildren), std::end(kChildren),
                     [&](const auto& row) { return holds(row.names, name); });
}

void report_unread(xml::View child, xml::View element, std::string_view help, Findings& findings) {
  Diagnostic& found =
      findings.report(child.name_span(), "ros2_control does not read " + quoted(child.name()) +
                                             " in " + quoted(element.name()));
  found.severity = Severity::warning;
  found.when(kInner);
  found.help(std::string(help));
}

void check_attributes(xml::View element, Findings& findings) {
  const Children* row = find_row(kAttributes, element);
  if (row == nullptr) return;
  for (const xml::Attribute& one : element.attributes()) {
    if (holds(row->names, one.name())) continue;
    const auto near = only_nearest(one.name(), row->names);
    if (!near || element.attribute(*near) != nullptr) continue;
    Diagnostic& found =
        findings.report(one.name_span(), "ros2_control does not read the attribute " +
                                             quoted(one.name()) + " of " + quoted(element.name()));
    found.severity = Severity::warning;
    found.when(kInner);
    found.help("did you mean " + quoted(*near) + "?");
    found.fixes.push_back({Applicability::unsafe, {{one.name_span(), std::string(*near)}}});
  }
}

void check_children(xml::View element, Findings& findings) {
  check_attributes(element, findings);
  const Children* row = find_row(kChildren, element);
  for (const xml::View child : element) {
    if (row != nullptr && holds(row->names, child.name())) {
      check_children(child, findings);
      continue;
    }
    if (is_read_elsewhere(child.name())) {
      report_unread(child, element, "move it to the element that it belongs to", findings);
      continue;
    }
    if (row == nullptr) continue;
    // A misspelt plugin has its own finding. Others may be for the hardware.
    const auto near = only_nearest(child.name(), row->names);
    if (!near || *near == "plugin") continue;
    report_unread(child, element, "did you mean " + quoted(*near) + "?", findings);
  }
}

void check_block(const Hardware& one, Findings& findings) {
  check_attributes(one.element, findings);
  for (const xml::View child : one.element) {
    if (holds(kOfControl, child.name())) {
      check_children(child, findings);
      continue;
    }
    if (child.name().starts_with("xacro:")) continue;  // SML1009
    Diagnostic& found = findings.report(
        child.name_span(), title_of(one) + " contains the unknown element " + quoted(child.name()));
    const auto near = only_nearest(child.name(), kOfControl);
    found.help(near ? "did you mean " + quoted(*near) + "?"
                    : "delete it, or move it out of `ros2_control`");
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& one : hardware_of(model)) check_block(one, findings);
}

constexpr std::string_view kParser = "ros2_control hardware_interface/src/component_parser.cpp";
constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::loses, "ignores it without a message", kParser, when(kInner)},
    no_hardware(),
    {&readers::ros, Effect::loses, "ros2_control ignores it without a message", kParser,
     when(kInner)},
    no_hardware_in_ros()};

}  // namespace

extern constinit const Rule sml3602_hardware_unknown_element{
    .id = "SML3602",
    .name = "hardware-unknown-element",
    .severity = Severity::error,
    .summary = "An element in `ros2_control` is not one that it reads there.",
    .remedy = "Correct the name of the element, or delete it.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3602_hardware_unknown_element_file
