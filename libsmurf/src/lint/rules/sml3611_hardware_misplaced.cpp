// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3611_hardware_misplaced_file {
namespace {

void look_into(xml::View element, Findings& findings) {
  for (const xml::View child : element) {
    if (child.name() == "ros2_control") {
      findings
          .report(child.name_span(), "ros2_control does not find this `ros2_control`, because it "
                                     "is in " +
                                         quoted(element.name()))
          .help("move it directly into `robot`");
    } else {
      look_into(child, findings);
    }
  }
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  if (!model.robot) return;
  for (const xml::View child : model.robot->document.view()) {
    if (child.name() != "ros2_control") look_into(child, findings);
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::loses, "does not see it",
     "ros2_control hardware_interface/src/component_parser.cpp parse_control_resources_from_urdf"},
    {&readers::ros, Effect::loses, "ros2_control does not see it",
     "ros2_control hardware_interface/src/component_parser.cpp parse_control_resources_from_urdf"},
};

}  // namespace

extern constinit const Rule sml3611_hardware_misplaced{
    .id = "SML3611",
    .name = "hardware-misplaced",
    .severity = Severity::warning,
    .summary = "An element `ros2_control` is not directly in `robot`.",
    .remedy = "Move it directly into `robot`.",
    .facts = kFacts};

}  // namespace smurf::rules::sml3611_hardware_misplaced_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3611_hardware_misplaced =
    rules::sml3611_hardware_misplaced_file::check;

}  // namespace smurf::companion_checks
