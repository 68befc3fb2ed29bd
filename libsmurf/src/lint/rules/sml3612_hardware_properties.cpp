// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3612_hardware_properties_file {
namespace {

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  for (const Hardware& one : hardware_of(model)) {
    for (const xml::View child : one.element) {
      if (child.name() != "properties") continue;
      findings.report(child.name_span(), title_of(one) + " has `properties`, an element of Jazzy")
          .help("delete it for Humble");
    }
  }
}

constexpr std::string_view kParser = "ros2_control hardware_interface/src/component_parser.cpp";
constexpr Fact kFacts[] = {
    in_humble(Effect::refuses, "throws an exception and loads no hardware at all"),
    {&readers::ros2_control, Effect::takes, "reads it", kParser},
    in_ros_humble(Effect::breaks, "ros2_control loads no hardware"),
    {&readers::ros, Effect::takes, "ros2_control reads it", kParser}};

}  // namespace

extern constinit const Rule sml3612_hardware_properties{
    .id = "SML3612",
    .name = "hardware-properties",
    .severity = Severity::error,
    .summary = "A `ros2_control` has an element `properties`, which Humble does not know.",
    .remedy = "Delete it, or use Jazzy or a later distribution.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml3612_hardware_properties_file
