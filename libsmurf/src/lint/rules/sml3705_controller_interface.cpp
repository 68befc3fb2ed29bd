// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>
#include <string>

#include "lint/companions/controllers.hpp"
#include "lint/companions/ros2_control.hpp"

namespace smurf::rules::sml3705_controller_interface_file {
namespace {

/// What the hardware of a robot offers: "elbow/position".
struct Offers {
  std::set<std::string> commands, states;
  std::set<std::string_view> joints;

  explicit Offers(const LinkedModel& model) {
    for (const Hardware& hardware : hardware_of(model)) {
      for (const HardwarePart& part : hardware.parts) {
        if (part.is_joint()) joints.insert(part.name);
        for (const HardwareInterface& one : part.interfaces) {
          (one.is_command ? commands : states)
              .insert(std::string(part.name) + "/" + std::string(one.name));
        }
      }
    }
  }
};

/// The joints of a controller that a ros2_control has; those of other controllers are not judged.
std::vector<std::string> joints_of(const RosController& controller, std::string_view key,
                                   const Offers& offers) {
  std::vector<std::string> joints;
  for (const yaml::View item : controller.list(key)) {
    if (offers.joints.contains(item.text())) joints.emplace_back(item.text());
  }
  return joints;
}

void check_interfaces(const RosController& controller, std::string_view key,
                      const std::vector<std::string>& joints, const std::set<std::string>& offered,
                      std::string_view what, Findings& findings) {
  std::vector<yaml::View> wanted = controller.list(key);
  if (const yaml::View one = controller.parameter(key); one && one.is_scalar()) {
    wanted.push_back(one);
  }
  for (const yaml::View interface : wanted) {
    if (is_placeholder(interface.text()) || interface.text().empty()) continue;
    std::string missing;
    for (const std::string& joint : joints) {
      if (offered.contains(joint + "/" + std::string(interface.text()))) continue;
      missing += (missing.empty() ? "" : ", ") + quoted(joint);
    }
    if (missing.empty()) continue;
    findings
        .report(interface.span(), title_of(controller) + " needs the " + std::string(what) +
                                      " interface " + quoted(interface.text()) + " of " +
                                      shortened(missing, 200) + ", which no ros2_control offers")
        .help("add it to the joint in `ros2_control`, or delete it here");
  }
}

void check_controller(const RosController& controller, const Offers& offers, Findings& findings) {
  if (controller.known == nullptr || !controller.section) return;
  const std::string_view type = controller.known->name;
  const bool is_trajectory = type == "joint_trajectory_controller/JointTrajectoryController";
  const bool is_forward = type == "forward_command_controller/ForwardCommandController";
  if (!is_trajectory && !is_forward) return;
  std::vector<std::string> commanded = joints_of(controller, "command_joints", offers);
  if (controller.list("command_joints").empty()) {
    commanded = joints_of(controller, "joints", offers);
  }
  const std::string_view key = is_trajectory ? "command_interfaces" : "interface_name";
  check_interfaces(controller, key, commanded, offers.commands, "command", findings);
  if (!is_trajectory) return;
  check_interfaces(controller, "state_interfaces", joints_of(controller, "joints", offers),
                   offers.states, "state", findings);
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  const Offers offers(model);
  if (offers.joints.empty()) return;              // its hardware may be in an xacro file
  std::map<std::string_view, std::size_t> files;  // that configure a controller of this name
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) ++files[one.name];
  });
  for_each_controller_file(companions, [&](const ControllerFile& file) {
    for (const RosController& one : file.controllers) {
      // Variants of a controller are for variants of the hardware.
      if (files[one.name] == 1) check_controller(one, offers, findings);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::ros2_control, Effect::breaks,
     "reports an error and does not activate the controller",
     "ros2_control resource_manager.cpp prepare_command_mode_switch"},
};

}  // namespace

extern constinit const Rule sml3705_controller_interface{
    .id = "SML3705",
    .name = "controller-interface",
    .severity = Severity::error,
    .summary = "A controller needs an interface of a joint that no `ros2_control` offers.",
    .remedy = "Add the interface to the joint in `ros2_control`, or delete it from the controller.",
    .facts = kFacts};

}  // namespace smurf::rules::sml3705_controller_interface_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3705_controller_interface =
    rules::sml3705_controller_interface_file::check;

}  // namespace smurf::companion_checks
