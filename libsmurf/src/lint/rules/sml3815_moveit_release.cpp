// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/moveit_files.hpp"
#include "lint/companions/pipelines.hpp"

namespace smurf::rules::sml3815_moveit_release_file {
namespace {

constexpr Circumstance kHumbleOnly{"Humble only"};
constexpr Circumstance kLater{"since Jazzy"};
constexpr Circumstance kClass{"class"};
constexpr Circumstance kServo{"servo"};
constexpr Circumstance kTimes{"times"};
constexpr Circumstance kAcceleration{"acceleration"};
constexpr Version kJazzy{2, 12};

void check_pipeline(const MoveitPipeline& pipeline, Findings& findings) {
  if (!pipeline.humble.empty() && !pipeline.later.empty()) return;  // SML3816
  const bool is_humble = !pipeline.humble.empty();
  const auto& signs = is_humble ? pipeline.humble : pipeline.later;
  if (!signs.empty()) {
    findings
        .report(signs.front().place, signs.front().what + " is read in " +
                                         (is_humble ? "Humble only" : "Jazzy and later only"))
        .when(is_humble ? kHumbleOnly : kLater)
        .help(signs.front().help);
  }
  if (!pipeline.without_times) return;
  findings.report(*pipeline.without_times, "no response adapter computes the times of a path")
      .when(kTimes)
      .help("add `default_planning_response_adapters/AddTimeOptimalParameterization`");
}

void check_solvers(yaml::View root, Findings& findings) {
  for (const yaml::View group : root) {
    if (!group.is_mapping()) continue;
    if (is_moveit_wrapper(group.key())) check_solvers(group, findings);
    const yaml::View solver = group.find("kinematics_solver");
    if (!solver || !solver.is_scalar() ||
        solver.text() != "lma_kinematics_plugin/LMAKinematicsPlugin")
      continue;
    findings.report(solver.span(), quoted(solver.text()) + " is in Humble only")
        .when(kHumbleOnly)
        .when(kClass)
        .help(
            "write `kdl_kinematics_plugin/KDLKinematicsPlugin`, or the solver of another package");
  }
}

/// The key `joint_limits` of the only file.
Span limits_in(const Companions& companions) {
  Span place;
  for_each_file(companions, CompanionKind::joint_limits, [&](const Companion&, yaml::View root) {
    yaml::View limits = root.find("joint_limits");
    for (const yaml::View member : root) {
      if (!limits && member.is_mapping()) limits = member.find("joint_limits");
    }
    if (limits) place = limits.key_span();
  });
  return place;
}

/// Parameters of MoveIt Servo that Jazzy does not have any more.
// The recursion is as deep as the file, whose depth is limited.
void check_servo(yaml::View mapping, Findings& findings) {
  const bool is_servo = bool(mapping.find("move_group_name"));
  for (const yaml::View member : mapping) {
    if (member.is_mapping()) check_servo(member, findings);
    if (!is_servo ||
        !is_one_of(member.key(), {"planning_frame", "ee_frame_name", "robot_link_command_frame",
                                  "low_latency_mode", "use_gazebo",
                                  "num_outgoing_halt_msgs_to_publish", "joint_limit_margin"})) {
      continue;
    }
    findings
        .report(member.key_span(), quoted(member.key()) + " of MoveIt Servo is read in Humble only")
        .when(kHumbleOnly)
        .when(kServo)
        .help("delete it");
  }
}

/// Joints that Jazzy cannot plan for, because they have no limit of the acceleration.
void check_accelerations(const LinkedModel& model, const Companions& companions,
                         Findings& findings) {
  std::set<std::string_view> limited, named;
  std::vector<yaml::View> without;
  std::size_t files = 0;
  for (const Companion& file : companions.files) {
    if (file.kind == CompanionKind::joint_limits && file.is_ros2) ++files;
  }
  if (files != 1 || !model.robot) return;
  for_each_joint_limit(companions, [&](const Companion& file, yaml::View joint) {
    if (!file.is_ros2) return;
    named.insert(joint.key());
    const yaml::View has = joint.find("has_acceleration_limits");
    if (has && has.is_scalar() && has.boolean() == true) {
      limited.insert(joint.key());
    } else {
      without.push_back(joint);
    }
  });
  if (limited.empty()) return;
  std::string names;
  Span place;
  for (const yaml::View joint : without) {
    if (!model.joint_index(joint.key())) continue;
    if (names.empty()) place = joint.key_span();
    names += (names.empty() ? "" : ", ") + quoted(joint.key());
  }
  const Companion* srdf = only_srdf(companions);
  for (const urdf::Joint& joint : model.robot->joints) {
    const bool is_driven = joint.is_movable() && !joint.mimic && joint.name;
    if (!is_driven || named.contains(*joint.name) || srdf == nullptr) continue;
    const bool is_passive = std::any_of(
        srdf->srdf->passive_joints.begin(), srdf->srdf->passive_joints.end(),
        [&](const srdf::PassiveJoint& one) { return one.name && *one.name == *joint.name; });
    if (is_passive) continue;
    if (names.empty()) place = limits_in(companions);
    names += (names.empty() ? "" : ", ") + quoted(*joint.name);
  }
  if (names.empty()) return;
  findings
      .report(place, "no acceleration limit for " + shortened(names, 200) +
                         ", without which Jazzy and later plan nothing")
      .when(kAcceleration)
      .help("add `has_acceleration_limits: true` and `max_acceleration`");
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  for (const Companion& file : companions.files) {
    const yaml::View root = file.document ? file.document->view() : yaml::View();
    if (!root || !root.is_mapping() || !file.is_ros2) continue;
    if (file.kind == CompanionKind::kinematics) check_solvers(root, findings);
  }
  for (const MoveitPipeline& one : moveit_pipelines(companions)) check_pipeline(one, findings);
  check_accelerations(model, companions, findings);
  for (const FrameFile& file : companions.surroundings.frame_files) {
    if (file.form != FrameFile::Form::parameters || !file.document) continue;
    const yaml::View root = file.document->view();
    if (root && root.is_mapping()) check_servo(root, findings);
  }
}

constexpr std::string_view kPipeline = "moveit2 planning_pipeline.cpp, branches humble and jazzy";

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::takes, "reads it", "moveit2 moveit_servo, branch humble",
     when(kHumbleOnly, kServo).before(kJazzy)},
    {&readers::moveit, Effect::loses, "ignores it: the parameter is not declared",
     "moveit2 moveit_servo servo_parameters.yaml, branch jazzy", when(kHumbleOnly, kServo)},
    {&readers::moveit, Effect::takes, "loads the solver",
     "moveit2 lma_kinematics_plugin, branch humble", when(kClass, kHumbleOnly).before(kJazzy)},
    {&readers::moveit, Effect::breaks, "finds no such solver, and has none for the group",
     "moveit2, branch jazzy: the package is gone", when(kClass, kHumbleOnly)},
    {&readers::moveit, Effect::takes, "reads it", kPipeline, when(kHumbleOnly).before(kJazzy)},
    {&readers::moveit, Effect::breaks, "finds no planner and no adapters: move_group does not plan",
     kPipeline, when(kHumbleOnly)},
    {&readers::moveit, Effect::breaks, "finds no planner and no adapters: move_group does not plan",
     kPipeline, when(kLater).before(kJazzy)},
    {&readers::moveit, Effect::takes, "reads it", kPipeline, when(kLater)},
    {&readers::moveit, Effect::takes, "does not read response adapters", kPipeline,
     when(kTimes).before(kJazzy)},
    {&readers::moveit, Effect::breaks, "sends paths without times, which controllers refuse",
     "moveit2 default_response_adapters, branch jazzy", when(kTimes)},
    {&readers::moveit, Effect::takes, "plans with 1 rad/s2, and warns",
     "moveit2 time_optimal_trajectory_generation.cpp, branch humble",
     when(kAcceleration).before(kJazzy)},
    {&readers::moveit, Effect::breaks,
     "plans nothing: no acceleration limit was defined for the joint",
     "moveit2 time_optimal_trajectory_generation.cpp, branch jazzy", when(kAcceleration)},
};

}  // namespace

extern constinit const Rule sml3815_moveit_release{
    .id = "SML3815",
    .name = "moveit-release",
    .severity = Severity::warning,
    .summary = "A parameter file of MoveIt is for another release.",
    .why = "Humble reads `planning_plugin` and a text of adapters; Jazzy and later read lists.",
    .remedy = "Write what the release reads.",
    .check_companions = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml3815_moveit_release_file
