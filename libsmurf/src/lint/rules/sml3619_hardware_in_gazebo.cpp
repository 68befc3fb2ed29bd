// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <string_view>

#include "base/text/words.hpp"
#include "lint/companions/gazebo.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3619_hardware_in_gazebo_file {
namespace {

/// The plugin of gz_ros2_control in the robot; none if Gazebo does not load its hardware.
xml::View control_plugin(const LinkedModel& model) {
  for (const GazeboPlugin& one : gazebo_plugins(model)) {
    if (one.file.find("gz_ros2_control-system") != std::string_view::npos ||
        one.file.find("ign_ros2_control-system") != std::string_view::npos) {
      return one.element;
    }
  }
  return {};
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  if (companions.surroundings.may_choose_hardware) return;  // by an argument
  const xml::View loader = control_plugin(model);
  if (!loader) return;
  for (const Hardware& hardware : hardware_of(model)) {
    const xml::View part = hardware.element.child("hardware");
    const xml::View plugin = part ? part.child("plugin") : xml::View();
    if (!plugin) continue;
    const std::string_view name = trimmed(plugin.text());
    if (!is_one_of(name, {"mock_components/GenericSystem", "fake_components/GenericSystem",
                          "topic_based_ros2_control/TopicBasedSystem",
                          "gazebo_ros2_control/GazeboSystem"})) {
      continue;
    }
    findings
        .report(plugin.text_span(), "Gazebo loads " + title_of(hardware) + ", and " + quoted(name) +
                                        " is no hardware of Gazebo")
        .label(loader.name_span(), "this plugin loads it")
        .help("write `gz_ros2_control/GazeboSimSystem` for Gazebo, or remove the plugin");
  }
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks,
     "gz_ros2_control reports that the class does not exist, and loads no hardware",
     "gz_ros2_control gz_ros2_control_plugin.cpp: pluginlib of GazeboSimSystemInterface"},
    {&readers::gazebo, Effect::breaks,
     "gz_ros2_control reports that the class does not exist, and loads no hardware",
     "gz_ros2_control gz_ros2_control_plugin.cpp: pluginlib of GazeboSimSystemInterface"},
};

}  // namespace

extern constinit const Rule sml3619_hardware_in_gazebo{
    .id = "SML3619",
    .name = "hardware-in-gazebo",
    .severity = Severity::warning,
    .summary = "Gazebo loads the hardware of a robot, whose class is not one for Gazebo.",
    .remedy =
        "Write the class of gz_ros2_control, or choose the class by an argument of the xacro.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3619_hardware_in_gazebo_file
