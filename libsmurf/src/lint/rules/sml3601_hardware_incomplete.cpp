// SPDX-License-Identifier: BSD-3-Clause

#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3601_hardware_incomplete_file {
namespace {

constexpr Circumstance kNew{"not read by Humble"};

/// What an element must have, by the name of the element above it.
struct Need {
  std::string_view parent, element, attribute;
};
constexpr Need kNeeds[] = {
    {"robot", "ros2_control", "name"},
    {"robot", "ros2_control", "type"},
    {"ros2_control", "joint", "name"},
    {"ros2_control", "sensor", "name"},
    {"ros2_control", "gpio", "name"},
    {"ros2_control", "transmission", "name"},
    {"transmission", "joint", "name"},
    {"transmission", "joint", "role"},
    {"transmission", "actuator", "name"},
    {"transmission", "actuator", "role"},
    {"", "command_interface", "name"},
    {"", "state_interface", "name"},
    {"", "param", "name"},
    {"", "limits", "enable"},
};

bool has_attribute(xml::View element, std::string_view name) {
  return element.attribute(name) != nullptr;
}

std::string title(xml::View element) {
  const std::string_view name = attribute_text(element, "name");
  return name.empty() ? "this `" + std::string(element.name()) + "`"
                      : std::string(element.name()) + " " + quoted(name);
}

void check_element(xml::View element, Findings& findings) {
  const xml::View parent = element.parent();
  std::string missing;
  for (const Need& need : kNeeds) {
    const bool is_here =
        need.element == element.name() && (need.parent.empty() || need.parent == parent.name());
    if (!is_here || has_attribute(element, need.attribute)) continue;
    missing += (missing.empty() ? " has no " : " and no ") + quoted(need.attribute);
  }
  if (!missing.empty()) {
    Diagnostic& found = findings.report(element.name_span(), title(element) + missing);
    if (element.name() == "limits") found.when(kNew);
    found.help("write the attribute");
  }
  for (const xml::View child : element) {
    const bool is_read = child.name() != "properties" && element.name() != "param";
    if (is_read) check_element(child, findings);
  }
}

void check_plugin(xml::View element, const Hardware& hardware, Findings& findings) {
  const xml::View plugin = element.child("plugin");
  const std::string what = std::string(element.name()) + " of " + title_of(hardware);
  if (!plugin) {
    // A misspelt element is reported at its place.
    for (const xml::View child : element) {
      if (child.name().starts_with("plug")) {
        findings.report(child.name_span(), what + " has no `plugin`, but " + quoted(child.name()))
            .help("write `<plugin>`");
        return;
      }
    }
    findings.report(element.name_span(), what + " has no `plugin`")
        .help("write `<plugin>PACKAGE/CLASS</plugin>`")
        .when(kNoPlugin);
  } else if (trimmed(plugin.text()).empty()) {
    findings.report(plugin.name_span(), "the plugin of " + what + " is empty")
        .help("write the name of a class, PACKAGE/CLASS");
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& one : hardware_of(model)) {
    check_element(one.element, findings);
    if (!one.element.child("hardware")) {
      findings.report(one.element.name_span(), title_of(one) + " has no `hardware`")
          .help("write `<hardware><plugin>PACKAGE/CLASS</plugin></hardware>`")
          .when(kNoPlugin);
    }
    for (const xml::View child : one.element) {
      if (is_one_of(child.name(), {"hardware", "transmission"})) {
        check_plugin(child, one, findings);
      }
    }
  }
}

constexpr std::string_view kUnread = "ros2_control does not read `limits`";
constexpr Fact kFacts[] = {in_humble(Effect::ignores, kUnread, when(kNew)), no_hardware(),
                           in_ros_humble(Effect::ignores, kUnread, when(kNew)),
                           no_hardware_in_ros()};

}  // namespace

extern constinit const Rule sml3601_hardware_incomplete{
    .id = "SML3601",
    .name = "hardware-incomplete",
    .severity = Severity::error,
    .summary = "An element in `ros2_control` lacks an attribute or a plugin that it needs.",
    .remedy = "Write the attribute or the plugin.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3601_hardware_incomplete_file
