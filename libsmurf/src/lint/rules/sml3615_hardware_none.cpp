// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/ros2_control.hpp"
#include "lint/imported_robot.hpp"

namespace smurf::rules::sml3615_hardware_none_file {
namespace {

void check(const LinkedModel& model, const Companions&, Findings& findings) {
  // ros2_control reads URDF only: a table in a world of Gazebo is no robot for it.
  if (!model.robot || is_of_other_language(model) || !hardware_of(model).empty()) return;
  const xml::View root = model.robot->document.view();
  if (!root) return;
  findings.report(root.name_span(), "the robot has no `ros2_control`")
      .help("add a `ros2_control` with the plugin of the hardware and its joints");
}

constexpr Fact kFacts[] = {
    no_hardware(),
};

}  // namespace

extern constinit const Rule sml3615_hardware_none{
    .id = "SML3615",
    .name = "hardware-none",
    .severity = Severity::info,
    .summary = "A robot for ros2_control has no element `ros2_control`.",
    .remedy = "Describe the hardware in a `ros2_control`.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml3615_hardware_none_file
