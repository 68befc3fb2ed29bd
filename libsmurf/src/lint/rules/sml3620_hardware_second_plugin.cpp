// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3620_hardware_second_plugin_file {
namespace {

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& hardware : hardware_of(model)) {
    const xml::View part = hardware.element.child("hardware");
    if (!part) continue;
    xml::View first;
    for (const xml::View child : part) {
      if (child.name() != "plugin") continue;
      if (!first) {
        first = child;
        continue;
      }
      findings.report(child.name_span(), title_of(hardware) + " has a second `plugin`")
          .label(first.name_span(), "the first one counts")
          .help("delete one of them");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::loses, "loads the first class and ignores the second",
     "ros2_control hardware_interface/src/component_parser.cpp"},
};

}  // namespace

extern constinit const Rule sml3620_hardware_second_plugin{
    .id = "SML3620",
    .name = "hardware-second-plugin",
    .severity = Severity::warning,
    .summary = "The hardware of a `ros2_control` names two plugins.",
    .remedy = "Delete the plugin that is not meant, or choose it with `xacro:if`.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3620_hardware_second_plugin_file
