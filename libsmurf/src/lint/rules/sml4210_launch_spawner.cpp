// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/launch.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml4210_launch_spawner_file {
namespace {

constexpr Circumstance kStopped{"stopped"};

bool takes_value(std::string_view option) {
  return is_one_of(option, {"-c", "--controller-manager", "-p", "--param-file", "-n", "--namespace",
                            "-t", "--controller-type", "--controller-manager-timeout",
                            "--switch-timeout", "--service-call-timeout", "--controller-ros-args",
                            "--ros-args", "-r", "--remap", "--params-file"});
}

/// The controllers that a spawner starts.
std::vector<const LaunchText*> controllers_of(const LaunchNode& node) {
  std::vector<const LaunchText*> names;
  for (std::size_t i = 0; i < node.arguments.size(); ++i) {
    const LaunchText& one = node.arguments[i];
    if (one.text == "--ros-args") break;
    if (one.text.starts_with("-")) {
      if (takes_value(one.text)) ++i;
    } else if (one.is_known && one.package.empty() && one.text.find('/') == std::string::npos) {
      names.push_back(&one);
    }
  }
  return names;
}

bool is_spawner(const LaunchNode& node) {
  return node.package.is_known && node.package.text == "controller_manager" &&
         node.executable.is_known && is_one_of(node.executable.text, {"spawner", "spawner.py"});
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  std::set<std::string_view> declared;
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) declared.insert(one.name);
  });
  const std::vector<std::string_view> known(declared.begin(), declared.end());
  for_each_launch(companions, [&](const LaunchFile& launch) {
    std::set<std::string_view> started;
    for (const LaunchNode& node : launch.nodes) {
      if (!is_spawner(node)) continue;
      for (const LaunchText* one : controllers_of(node)) started.insert(one->text);
    }
    const bool has_known = std::any_of(started.begin(), started.end(), [&](std::string_view one) {
      return declared.contains(one);
    });
    for (const LaunchNode& node : launch.nodes) {
      if (!is_spawner(node)) continue;
      for (const LaunchText& one : node.arguments) {
        if (one.text != "--stopped") continue;
        findings.report(one.span, "the spawner has no option `--stopped` since Jazzy")
            .when(kStopped)
            .help("write `--inactive`")
            .severity = Severity::info;
      }
      if (!has_known && !launch.is_of_robot) continue;
      for (const LaunchText* one : controllers_of(node)) {
        if (declared.contains(one->text) || one->by_default) continue;
        const auto near = near_name(one->text, known);
        if (!near || (!has_known && started.contains(*near))) continue;
        findings
            .report(one->span,
                    "no file around the robot declares the controller " + quoted(one->text))
            .help("did you mean " + quoted(*near) + "?");
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::takes, "starts the controller inactive",
     "ros2_control spawner.py, branch humble", when(kStopped).before(kParserOfJazzy)},
    {&readers::ros2_control, Effect::refuses, "ends the spawner: it does not know the option",
     "ros2_control spawner.py, branch jazzy", when(kStopped)},
    {&readers::ros2_control, Effect::refuses, "ends the spawner: it cannot load the controller",
     "ros2_control spawner.py, controller_manager.cpp"},
};

}  // namespace

extern constinit const Rule sml4210_launch_spawner{
    .id = "SML4210",
    .name = "launch-spawner",
    .severity = Severity::warning,
    .summary = "A launch file starts a controller that no parameter file declares.",
    .remedy = "Write the name of a controller that the parameter file declares.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4210_launch_spawner_file
