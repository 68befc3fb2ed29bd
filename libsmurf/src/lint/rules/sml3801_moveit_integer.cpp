// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3801_moveit_integer_file {
namespace {

constexpr Circumstance kDropped{"dropped"};
constexpr Circumstance kScaling{"scaling"};

void check_value(const Companion& file, yaml::View value, const std::string& path,
                 Findings& findings) {
  const std::string text(value.text());
  Diagnostic& found =
      findings.report(value.span(), quoted(path) + " is an integer, but MoveIt needs a double");
  const bool is_fatal =
      file.kind == CompanionKind::joint_limits || file.kind == CompanionKind::kinematics;
  if (!is_fatal) found.when(kDropped);
  if (path.starts_with("default_")) {
    found.severity = Severity::warning;
    found.when(kScaling);
  }
  found.help("write " + quoted(text + ".0"));
  if (text.find_first_not_of("+-0123456789") == std::string::npos) {
    found.fixes.push_back({Applicability::safe, {{value.span(), text + ".0"}}});
  }
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_moveit_value(companions, [&](const Companion& file, const RosParameter& parameter,
                                        yaml::View value, const std::string& path) {
    // ROS 1 converts integers.
    if (!file.is_ros2 || parameter.type != 'd' || !value.is_scalar()) return;
    if (value.type() == yaml::ScalarType::integer) check_value(file, value, path, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks,
     "RViz and programs with MoveGroupInterface end with an exception",
     "moveit2 move_group_interface.cpp:168; rclcpp node_impl.hpp get_parameter_or", when(kScaling)},
    {&readers::moveit, Effect::breaks,
     "reports an error and does not use the controller, "
     "the sensor or the setting",
     "moveit2 moveit_simple_controller_manager.cpp, ompl_interface.cpp, "
     "depth_image_octomap_updater.cpp; rclcpp parameter_value.cpp",
     when(kDropped)},
    {&readers::moveit, Effect::crashes, "move_group and RViz end with an exception",
     "moveit2 robot_model_loader.cpp; moveit2 issues 2776, 3604, 3716"},
};

}  // namespace

extern constinit const Rule sml3801_moveit_integer{
    .id = "SML3801",
    .name = "moveit-integer",
    .severity = Severity::error,
    .summary = "A number in a parameter file of MoveIt is an integer, but must be a double.",
    .why = "ROS 2 does not convert an integer to a double.",
    .remedy = "Write a decimal point: `1.0`.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3801_moveit_integer_file
