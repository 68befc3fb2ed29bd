// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string_view>

#include "base/text/words.hpp"
#include "lint/companions/launch.hpp"

namespace smurf::rules::sml4207_launch_joint_states_file {
namespace {

constexpr Circumstance kTwice{"twice"};

bool publishes_states(const LaunchNode& node) {
  return runs(node, "joint_state_publisher", "joint_state_publisher") ||
         runs(node, "joint_state_publisher_gui", "joint_state_publisher_gui");
}

/// The broadcaster that a spawner starts.
const LaunchText* broadcaster_of(const LaunchNode& node) {
  if (!node.executable.is_known || node.executable.text != "spawner") return nullptr;
  for (const LaunchText& one : node.arguments) {
    if (one.text == "joint_state_broadcaster") return &one;
  }
  return nullptr;
}

void check_twice(const LaunchFile& launch, Findings& findings) {
  const LaunchNode* publisher = nullptr;
  const LaunchText* broadcaster = nullptr;
  for (const LaunchNode& node : launch.nodes) {
    if (node.is_conditional) continue;
    const bool has_sources =
        node.has_unknown_parameters ||
        std::any_of(node.parameters.begin(), node.parameters.end(),
                    [](const auto& one) { return one.first.text == "source_list"; });
    if (publishes_states(node) && !has_sources && !node.has_namespace) publisher = &node;
    if (const LaunchText* one = broadcaster_of(node)) broadcaster = one;
  }
  if (publisher == nullptr || broadcaster == nullptr) return;
  findings
      .report(publisher->span, "joint_state_publisher and joint_state_broadcaster both publish "
                               "/joint_states")
      .label(broadcaster->span, "the broadcaster is started here")
      .when(kTwice)
      .help("delete joint_state_publisher");
}

/// A launch file that starts nothing that could move the joints.
void check_none(const LinkedModel& model, const LaunchFile& launch, Findings& findings) {
  const LaunchNode* publisher = nullptr;
  for (const LaunchNode& node : launch.nodes) {
    if (runs(node, "robot_state_publisher", "robot_state_publisher")) {
      publisher = &node;
    } else if (!node.executable.is_known ||
               !is_one_of(node.executable.text, {"rviz2", "rviz", "static_transform_publisher"})) {
      return;
    }
  }
  const bool is_movable =
      model.robot &&
      std::any_of(model.robot->joints.begin(), model.robot->joints.end(),
                  [](const urdf::Joint& one) { return one.is_movable() && !one.mimic; });
  if (publisher == nullptr || !is_movable || launch.has_includes || launch.is_included) return;
  if (launch.nodes.size() < 2) return;  // it may be started with others
  findings
      .report(publisher->executable.span,
              "nothing here publishes /joint_states, so movable links have no place")
      .help("add joint_state_publisher_gui, unless another launch file publishes them")
      .severity = Severity::info;
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for_each_launch(companions, [&](const LaunchFile& launch) {
    check_twice(launch, findings);
    const bool is_of_robot = std::any_of(launch.descriptions.begin(), launch.descriptions.end(),
                                         [](const auto& one) { return one.is_of_robot; });
    if (is_of_robot) check_none(model, launch, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros, Effect::changes, "lets the robot jump between zero and its real position",
     "robot_state_publisher.cpp: the last message counts", when(kTwice)},
    {&readers::ros, Effect::loses, "publishes no transform of movable links",
     "robot_state_publisher.cpp"},
};

}  // namespace

extern constinit const Rule sml4207_launch_joint_states{
    .id = "SML4207",
    .name = "launch-joint-states",
    .severity = Severity::warning,
    .summary = "Two nodes of a launch file publish the joint states of a robot, or none does.",
    .remedy = "Start one of joint_state_publisher and joint_state_broadcaster.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4207_launch_joint_states_file
