// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <string>

#include "lint/companions/ros2_control.hpp"
#include "lint/companions/trajectory.hpp"

namespace smurf::rules::sml3711_controller_version_file {
namespace {

constexpr Circumstance kNoHumble{"not in Humble"};
constexpr Circumstance kNoJazzy{"not in Jazzy"};
constexpr Circumstance kNoKilted{"not in Kilted"};
constexpr Circumstance kNoRolling{"not in Rolling"};
constexpr Circumstance kClass{"class"};
constexpr Circumstance kTrajectory{"trajectory"};

constexpr Version kKilted{5};
constexpr Version kRolling{6};

/// What replaces a class in later distributions: ros2_controllers, branches kilted and master.
std::string_view successor_of(std::string_view name) {
  if (name.ends_with("_controllers/GripperActionController")) {
    return "parallel_gripper_action_controller/GripperActionController";
  }
  return name.find("_controllers/JointGroup") != std::string_view::npos
             ? std::string_view("forward_command_controller/ForwardCommandController")
             : std::string_view();
}

void mark(std::string_view distributions, Diagnostic& found) {
  const auto lacks = [&](char one) { return distributions.find(one) == std::string_view::npos; };
  if (lacks('h')) found.when(kNoHumble);
  if (lacks('j')) found.when(kNoJazzy);
  if (lacks('k')) found.when(kNoKilted);
  if (lacks('r')) found.when(kNoRolling);
}

void check_parameter(yaml::View value, const std::string& path, const RosParameter& parameter,
                     const RosController& controller, Findings& findings) {
  if (parameter.distributions == controller.known->distributions) return;
  Diagnostic& found = findings.report(value.key_span(),
                                      "only " + distribution_names(parameter.distributions) +
                                          " read " + quoted(path) + " of " + title_of(controller));
  mark(parameter.distributions, found);
  found.help("delete it, or use the parameter of that version");
}

/// What trajectory controllers accept since Jazzy.
void check_trajectory(const RosController& controller, Findings& findings) {
  if (!is_trajectory_controller(controller)) return;
  const auto report = [&](std::string_view key, const std::string& what) {
    Diagnostic& found = findings.report(controller.parameter(key).place(),
                                        "only " + distribution_names("jkr") + " accept " + what +
                                            " for " + title_of(controller));
    mark("jkr", found);
    found.when(kTrajectory);
    return &found;
  };
  const std::set<std::string_view> commands = names_in(controller, "command_interfaces");
  if (commands.size() == 2 && commands.contains("effort") && commands.contains("position")) {
    report("command_interfaces", "`effort` with `position`")->help("write one of them");
  }
  const std::size_t joints = controller.list("joints").size();
  const std::size_t commanded = controller.list("command_joints").size();
  if (commanded > 0 && commanded < joints) {
    report("command_joints", "fewer `command_joints` than `joints`")
        ->help("write as many `command_joints` as `joints`");
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& controller : file.controllers) {
      if (controller.known == nullptr) continue;
      const std::string_view all = controller.known->distributions;
      if (!distribution_names(all).empty()) {
        Diagnostic& found =
            findings.report(controller.type.span(), "only " + distribution_names(all) + " have " +
                                                        quoted(controller.known->name));
        mark(all, found);
        found.when(kClass);
        const std::string_view next = successor_of(controller.known->name);
        found.help(next.empty() ? std::string("use the controller of that version")
                                : "use " + quoted(next));
      }
      if (!controller.section) continue;
      check_trajectory(controller, findings);
      for_each_parameter(
          controller.section, parameters_of(*controller.known),
          [&](yaml::View value, const std::string& path, const RosParameter& parameter) {
            check_parameter(value, path, parameter, controller, findings);
          });
    }
  });
}

constexpr std::string_view kSource = "ros2_controllers *_parameters.yaml of its branches";
constexpr std::string_view kNoClass = "reports an error and does not load the controller";
constexpr std::string_view kNoParameter = "ignores it without a message";

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks, kNoClass, kSource,
     when(kClass, kNoHumble).before(kParserOfJazzy)},
    {&readers::ros2_control, Effect::breaks, kNoClass, kSource,
     when(kClass, kNoJazzy).since(kParserOfJazzy).before(kKilted)},
    {&readers::ros2_control, Effect::breaks, kNoClass, kSource,
     when(kClass, kNoKilted).since(kKilted).before(kRolling)},
    {&readers::ros2_control, Effect::breaks, kNoClass, kSource,
     when(kClass, kNoRolling).since(kRolling)},
    {&readers::ros2_control, Effect::takes, "loads it", kSource, when(kClass)},
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not configure the controller",
     "ros2_controllers joint_trajectory_controller.cpp, validate_jtc_parameters.hpp of its branches",
     when(kTrajectory, kNoHumble).before(kParserOfJazzy)},
    {&readers::ros2_control, Effect::loses, kNoParameter, kSource,
     when(kNoHumble).before(kParserOfJazzy)},
    {&readers::ros2_control, Effect::loses, kNoParameter, kSource,
     when(kNoJazzy).since(kParserOfJazzy).before(kKilted)},
    {&readers::ros2_control, Effect::loses, kNoParameter, kSource,
     when(kNoKilted).since(kKilted).before(kRolling)},
    {&readers::ros2_control, Effect::loses, kNoParameter, kSource,
     when(kNoRolling).since(kRolling)},
    {&readers::ros2_control, Effect::takes, "reads it", kSource},
};

}  // namespace

extern constinit const Rule sml3711_controller_version{
    .id = "SML3711",
    .name = "controller-version",
    .severity = Severity::info,
    .summary = "A controller or one of its parameters is not in every distribution of ROS.",
    .remedy = "Use the controllers and parameters of the distribution.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml3711_controller_version_file
