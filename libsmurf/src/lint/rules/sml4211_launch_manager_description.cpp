// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "lint/companions/launch.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml4211_launch_manager_description_file {
namespace {

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    const bool has_publisher =
        std::any_of(launch.nodes.begin(), launch.nodes.end(), [](const LaunchNode& one) {
          return !one.executable.is_known || one.executable.text == "robot_state_publisher";
        });
    if (has_publisher || launch.has_includes || launch.is_included) return;
    for (const LaunchNode& node : launch.nodes) {
      if (!runs(node, "controller_manager", "ros2_control_node")) continue;
      for (const auto& [name, value] : node.parameters) {
        if (name.text != "robot_description") continue;
        findings
            .report(name.span, "ros2_control_node reads `robot_description` from the topic only, "
                               "and no robot_state_publisher is started")
            .help("start robot_state_publisher with the robot");
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::takes, "reads the parameter",
     "ros2_control controller_manager.cpp, branch humble", Where{}.before(kParserOfJazzy)},
    {&readers::ros2_control, Effect::refuses,
     "waits for the topic robot_description, and starts nothing",
     "ros2_control controller_manager.cpp, branch jazzy"},
};

}  // namespace

extern constinit const Rule sml4211_launch_manager_description{
    .id = "SML4211",
    .name = "launch-manager-description",
    .severity = Severity::warning,
    .summary =
        "ros2_control_node gets the robot as a parameter, which it does not read since Jazzy.",
    .remedy = "Start robot_state_publisher, which publishes the robot.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml4211_launch_manager_description_file
