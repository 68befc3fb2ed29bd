// SPDX-License-Identifier: BSD-3-Clause
#include "base/text/counted.hpp"
#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3614_hardware_old_transmission_file {
namespace {

/// The interface of a transmission of ROS 1; none if it has none.
xml::View old_interface(xml::View transmission) {
  for (const xml::View part : transmission) {
    if (!is_one_of(part.name(), {"joint", "actuator"})) continue;
    if (const xml::View found = part.child("hardwareInterface")) return found;
  }
  return {};
}

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  if (hardware_of(model).empty()) return;
  Diagnostic* found = nullptr;
  std::size_t count = 0;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View element(model.robot->document, id);
    if (element.name() != "transmission" || !old_interface(element)) continue;
    ++count;
    if (found != nullptr) continue;
    found = &findings.report(element.name_span(),
                             "this transmission is for ROS 1; the robot has `ros2_control`");
    found->help("delete it if the robot is used in ROS 2 only");
  }
  if (count > 1) found->note(counted(count - 1, "more transmission") + " of this robot like it");
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::ignores, "does not look at it",
     "ros2_control hardware_interface/src/component_parser.cpp"},
};

}  // namespace

extern constinit const Rule sml3614_hardware_old_transmission{
    .id = "SML3614",
    .name = "hardware-old-transmission",
    .severity = Severity::info,
    .summary = "A robot with `ros2_control` has transmissions of ROS 1, too.",
    .remedy = "Delete the transmissions if the robot is used in ROS 2 only.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3614_hardware_old_transmission_file
