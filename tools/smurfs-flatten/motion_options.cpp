// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/motion_options.hpp"

#include "base/numbers/numbers.hpp"

namespace smurf::tools {
namespace {

/// "0.5", or "arm_*=0.5" for some joints.
Setter append_number(std::vector<JointNumber>& numbers) {
  return [&numbers](std::string_view value) -> std::optional<std::string> {
    const std::size_t equals = value.rfind('=');
    const bool has_joints = equals != std::string_view::npos;
    const auto number = parse_number(has_joints ? value.substr(equals + 1) : value);
    constexpr double kMost = 1e12;
    if (!number || !(*number >= 0 && *number <= kMost)) {
      return "needs a number from 0 to 1e12, or JOINTS=NUMBER, such as arm_*=50";
    }
    numbers.push_back({has_joints ? std::string(value.substr(0, equals)) : "", *number});
    return std::nullopt;
  };
}

}  // namespace

std::vector<Option> motor_options(MotorOptions& motors, std::string& controllers,
                                  std::string_view help) {
  return {{.name = "actuator",
           .metavar = "KIND",
           .help = help,
           .values = {"auto", "position", "velocity", "effort"},
           .set = choose<MotorKind>(motors.kind, {{"auto", MotorKind::automatic},
                                                  {"position", MotorKind::position},
                                                  {"velocity", MotorKind::velocity},
                                                  {"effort", MotorKind::effort}})},
          {.name = "kp",
           .metavar = "[JOINTS=]NUMBER",
           .help = "Set the stiffness of motors of positions, N m/rad or N/m, for all joints or "
                   "for those whose name fits JOINTS, a pattern with `*`.",
           .set = append_number(motors.kp)},
          {.name = "kv",
           .metavar = "[JOINTS=]NUMBER",
           .help = "Set the damping of motors, N m s/rad or N s/m.",
           .set = append_number(motors.kv)},
          {.name = "armature",
           .metavar = "[JOINTS=]NUMBER",
           .help = "Set the inertia of motors at their joints, kg m^2 or kg (mjcf).",
           .set = append_number(motors.armature)},
          {.name = "controllers",
           .metavar = "FILE",
           .help =
               "Read the kinds and gains of motors from the controllers of ros2_control in this "
               "parameter file; `none`: from no file. By default, from the files that belong to "
               "the robot, as for smurf-lint.",
           .set = set_text(controllers)}};
}

std::vector<Option> contact_options(SelfCollision& choice, std::string& srdf,
                                    bool& excludes_overlaps) {
  return {
      {.name = "self-collision",
       .metavar = "CHOICE",
       .help =
           "Choose which links of a robot can touch each other. none; neighbours: all but those that "
           "a joint connects; srdf: these, without the pairs that the SRDF disables; all. The "
           "default is srdf in mjcf and dmd, none in usda, and what the model says in sdf.",
       .values = {"none", "neighbours", "srdf", "all"},
       .set = choose<SelfCollision>(choice, {{"none", SelfCollision::none},
                                             {"neighbours", SelfCollision::neighbours},
                                             {"srdf", SelfCollision::srdf},
                                             {"all", SelfCollision::all}})},
      {.name = "srdf",
       .metavar = "FILE",
       .help =
           "Read pairs of links that cannot touch from this SRDF. By default, it is the one with "
           "the name of the robot beside the URDF, or in srdf/ or config/ there or one folder up.",
       .set = set_text(srdf)},
      {.name = "exclude-overlaps",
       .help = "Leave out the contacts of links that overlap at the start, which push each other "
               "apart. --actuator auto implies it.",
       .set = set_flag(excludes_overlaps)}};
}

}  // namespace smurf::tools
