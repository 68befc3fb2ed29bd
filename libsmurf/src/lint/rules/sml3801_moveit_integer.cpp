// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3801_moveit_integer_file {
namespace {

constexpr std::array<std::string_view, 7> kDoubles = {
    "max_position", "min_position",     "max_velocity", "max_acceleration",
    "min_velocity", "max_deceleration", "max_jerk"};

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_joint_limit(companions, [&](const Companion& file, yaml::View joint) {
    if (!file.is_ros2) return;  // ROS 1 converts integers
    for (const std::string_view name : kDoubles) {
      const yaml::View value = joint.find(name);
      if (!value || !value.is_scalar() || value.type() != yaml::ScalarType::integer) continue;
      const std::string text(value.text());
      Diagnostic& found =
          findings.report(value.span(), quoted(name) + " of joint " + quoted(joint.key()) +
                                            " is an integer, but MoveIt needs a double");
      found.help("write " + quoted(text + ".0"));
      if (text.find_first_not_of("+-0123456789") == std::string::npos) {
        found.fixes.push_back({Applicability::safe, {{value.span(), text + ".0"}}});
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::crashes, "move_group and RViz end with an exception",
     "moveit2 robot_model_loader.cpp; moveit2 issues 2776, 3604, 3716"},
};

}  // namespace

extern constinit const Rule sml3801_moveit_integer{
    .id = "SML3801",
    .name = "moveit-integer",
    .severity = Severity::error,
    .summary = "A limit in joint_limits.yaml is an integer.",
    .why = "ROS 2 does not convert an integer to a double.",
    .remedy = "Write a decimal point: `1.0`.",
    .facts = kFacts};

}  // namespace smurf::rules::sml3801_moveit_integer_file

namespace smurf::companion_checks {

extern constinit const CompanionCheck sml3801_moveit_integer =
    rules::sml3801_moveit_integer_file::check;

}  // namespace smurf::companion_checks
