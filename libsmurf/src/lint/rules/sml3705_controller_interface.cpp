// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/words.hpp"
#include "lint/companions/ros2_control.hpp"
#include "lint/companions/trajectory.hpp"

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

/// The interfaces that a class of controllers uses of the joints in a parameter: those that another
/// parameter lists, or these.
struct Use {
  std::string_view type, joints;
  std::string_view commands_in, commands;
  std::string_view states_in, states;
};
constexpr Use kUses[] = {
    {"joint_trajectory_controller/JointTrajectoryController", "joints", "command_interfaces", "",
     "state_interfaces", ""},
    {"forward_command_controller/ForwardCommandController", "joints", "interface_name", "", "", ""},
    {"forward_command_controller/MultiInterfaceForwardCommandController", "joint",
     "interface_names", "", "", ""},
    {"position_controllers/JointGroupPositionController", "joints", "", "position", "", ""},
    {"velocity_controllers/JointGroupVelocityController", "joints", "", "velocity", "", ""},
    {"effort_controllers/JointGroupEffortController", "joints", "", "effort", "", ""},
    {"position_controllers/GripperActionController", "joint", "", "position", "",
     "position velocity"},
    {"effort_controllers/GripperActionController", "joint", "", "effort", "", "position velocity"},
    {"parallel_gripper_action_controller/GripperActionController", "joint", "", "position",
     "state_interfaces", ""},
    {"diff_drive_controller/DiffDriveController", "left_wheel_names", "", "velocity", "", ""},
    {"diff_drive_controller/DiffDriveController", "right_wheel_names", "", "velocity", "", ""},
    {"pid_controller/PidController", "dof_names", "command_interface", "", "", ""},
};

/// Whether the controller accepts a value; SML3710 reports others.
bool is_accepted(const RosController& controller, std::string_view key, std::string_view text) {
  for (const RosParameter& parameter : parameters_of(*controller.known)) {
    if (parameter.path != key) continue;
    for (const ValueCondition& one : conditions_of(parameter)) {
      if (one.kind != ValueCondition::Kind::one_of) continue;
      if (std::find(one.texts.begin(), one.texts.end(), text) == one.texts.end()) return false;
    }
  }
  return true;
}

/// The texts of a parameter, one or a list of them.
std::vector<yaml::View> texts_of(const RosController& controller, std::string_view key) {
  std::vector<yaml::View> texts = controller.list(key);
  const yaml::View one = key.empty() ? yaml::View() : controller.parameter(key);
  if (one && one.is_scalar()) texts.push_back(one);
  return texts;
}

/// The joints of a controller that a ros2_control has; those of other controllers are not judged.
std::vector<std::string> joints_of(const RosController& controller, std::string_view key,
                                   const Offers& offers) {
  std::vector<std::string> joints;
  for (const yaml::View item : texts_of(controller, key)) {
    if (offers.joints.contains(item.text())) joints.emplace_back(item.text());
  }
  return joints;
}

class Checker {
 public:
  Checker(const RosController& controller, const Offers& offers, Findings& findings)
      : controller_(controller), offers_(offers), findings_(findings) {}

  void check(const Use& use) const {
    std::vector<std::string> commanded = joints_of(controller_, "command_joints", offers_);
    if (controller_.list("command_joints").empty()) {
      commanded = joints_of(controller_, use.joints, offers_);
    }
    // SML3706 reports commands that do not go together, and what to write instead.
    const bool is_reported = is_trajectory_controller(controller_) &&
                             !why_not_together(names_in(controller_, use.commands_in)).empty();
    for (const yaml::View one : texts_of(controller_, use.commands_in)) {
      if (is_reported || !is_accepted(controller_, use.commands_in, one.text())) continue;
      check_one(one.text(), one.span(), commanded, true);
    }
    const std::vector<std::string> joints = joints_of(controller_, use.joints, offers_);
    for (const yaml::View one : texts_of(controller_, use.states_in)) {
      if (!is_accepted(controller_, use.states_in, one.text())) continue;
      check_one(one.text(), one.span(), joints, false);
    }
    if (joints.empty()) return;
    const Span place = controller_.parameter(use.joints).place();
    check_words(use.commands, place, joints, true);
    check_words(use.states, place, joints, false);
  }

 private:
  void check_words(std::string_view words, Span place, const std::vector<std::string>& joints,
                   bool is_command) const {
    for (std::size_t at = 0;;) {
      const std::string_view word = next_word(words, at);
      if (word.empty()) return;
      check_one(word, place, joints, is_command);
    }
  }

  void check_one(std::string_view interface, Span place, const std::vector<std::string>& joints,
                 bool is_command) const {
    if (is_placeholder(interface) || interface.empty()) return;
    const std::set<std::string>& offered = is_command ? offers_.commands : offers_.states;
    std::string missing;
    for (const std::string& joint : joints) {
      if (offered.contains(joint + "/" + std::string(interface))) continue;
      missing += (missing.empty() ? "" : ", ") + quoted(joint);
    }
    if (missing.empty()) return;
    findings_
        .report(place, title_of(controller_) + " needs the " +
                           (is_command ? std::string("command") : std::string("state")) +
                           " interface " + quoted(interface) + " of " + shortened(missing, 200) +
                           ", which no ros2_control offers")
        .help("add it to the joint in `ros2_control`, or delete it here");
  }

  const RosController& controller_;
  const Offers& offers_;
  Findings& findings_;
};

void check_controller(const RosController& controller, const Offers& offers, Findings& findings) {
  if (controller.known == nullptr || !controller.section) return;
  for (const Use& use : kUses) {
    if (use.type == controller.known->name) Checker(controller, offers, findings).check(use);
  }
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
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3705_controller_interface_file
