// SPDX-License-Identifier: BSD-3-Clause
#include <cctype>
#include <string>

#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3811_moveit_value_type_file {
namespace {

constexpr Circumstance kDropped{"dropped"};

/// Parameters whose type depends on the release; SML3815 judges them.
bool is_of_release(std::string_view path) {
  return is_one_of(
      path, {"planning_plugin", "planning_plugins", "request_adapters", "response_adapters"});
}

void check_scalar(const Companion& file, yaml::View value, const std::string& path, char wanted,
                  Findings& findings) {
  const char got = rcl_type_of(value);
  // SML3801 reports integers.
  if (got == 0 || got == wanted || (got == 'i' && wanted == 'd')) return;
  const bool is_quoted = value.style() != yaml::Style::plain;
  Diagnostic& found = findings.report(
      value.span(), quoted(path) + " is a " + std::string(parameter_type_name(got)) +
                        ", but MoveIt needs a " + std::string(parameter_type_name(wanted)));
  const bool is_fatal =
      file.kind == CompanionKind::joint_limits || file.kind == CompanionKind::kinematics;
  if (!is_fatal) found.when(kDropped);
  if (wanted == 's') {
    found.help("write it in quotes");
  } else {
    found.help(is_quoted ? "write it without quotes"
                         : "write a " + std::string(parameter_type_name(wanted)));
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_moveit_value(companions, [&](const Companion& file, const RosParameter& parameter,
                                        yaml::View value, const std::string& path) {
    if (!file.is_ros2 || is_of_release(parameter.path)) return;  // ROS 1 converts some of them
    if (value.key() == "controller_names") return;               // SML3804 reports it
    const bool is_list = std::isupper(static_cast<unsigned char>(parameter.type)) != 0;
    if (value.is_scalar() && !is_list) {
      check_scalar(file, value, path, parameter.type, findings);
    } else if (value.is_scalar() && is_list && rcl_type_of(value) != 0) {
      findings
          .report(value.span(), quoted(path) + " must be a " + std::string(type_name(parameter)))
          .help("write `[" + std::string(value.text()) + "]`")
          .when(kDropped);
    } else if (value.is_sequence() && !is_list) {
      findings
          .report(value.place(),
                  quoted(path) + " is a list, but must be a " + std::string(type_name(parameter)))
          .help("write one value")
          .when(kDropped);
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks,
     "reports an error and does not use the controller, the sensor or the setting",
     "moveit2 moveit_simple_controller_manager.cpp, ompl_interface.cpp; rclcpp parameter_value.cpp",
     when(kDropped)},
    {&readers::moveit, Effect::crashes, "move_group and RViz end with an exception",
     "moveit2 robot_model_loader.cpp; rclcpp parameter_value.cpp"},
};

}  // namespace

extern constinit const Rule sml3811_moveit_value_type{
    .id = "SML3811",
    .name = "moveit-value-type",
    .severity = Severity::error,
    .summary = "A value in a parameter file of MoveIt has another type than MoveIt reads.",
    .why = "ROS 2 does not convert a text to a number.",
    .remedy = "Write a value of the type of the parameter, without quotes for a number.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3811_moveit_value_type_file
