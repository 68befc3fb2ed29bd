// SPDX-License-Identifier: BSD-3-Clause
// Reads the notation of the tables of parameters, and lists those of MoveIt. Sources: moveit2
// (8fcb5d2) robot_model_loader.cpp, kinematics_parameters.yaml,
// moveit_simple_controller_manager.cpp, trajectory_execution_manager.cpp, ompl_interface.cpp,
// occupancy_map_monitor_middleware_handle.cpp, pointcloud_octomap_updater.cpp,
// depth_image_octomap_updater.cpp; kdl_kinematics_parameters.yaml.
#include "ast/ros_parameters.hpp"

#include <algorithm>

#include "base/numbers/numbers.hpp"
#include "base/text/lists.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

/// Parameters of all controllers: controller_interface, rclcpp.
constexpr std::string_view kCommon =
    "type:s update_rate:i is_async:b=false thread_priority:i use_sim_time:b params_file:s "
    "fallback_controllers:S async_parameters.scheduling_policy:s "
    "async_parameters.cpu_affinity:I async_parameters.thread_priority:i "
    "async_parameters.wait_until_initial_trigger:b async_parameters.print_warnings:b";

/// controller_manager_parameters.yaml of ros2_control, branches jazzy, kilted and master.
constexpr std::string_view kManager =
    "update_rate:i=100{>0} enforce_command_limits:b@jkr handle_exceptions:b=true@jkr "
    "hardware_components_initial_state.unconfigured:S{unique} "
    "hardware_components_initial_state.inactive:S{unique} "
    "hardware_components_initial_state.shutdown_on_initial_state_failure:b@jkr "
    "defaults.switch_controller.strictness:s{one:strict,best_effort}@jkr "
    "defaults.allow_controller_activation_with_inactive_hardware:b=false@jkr "
    "defaults.deactivate_controllers_on_hardware_self_deactivate:b=true@jkr "
    "overruns.print_warnings:b@jkr use_sim_time:b";

/// In the notation of the controllers.
constexpr MoveitFile kMoveitFiles[] = {
    {"joint_limits.yaml",
     "default_velocity_scaling_factor:d{>0;<=1} default_acceleration_scaling_factor:d{>0;<=1} "
     "joint_limits.*.has_position_limits:b joint_limits.*.min_position:d "
     "joint_limits.*.max_position:d joint_limits.*.has_velocity_limits:b=false "
     "joint_limits.*.max_velocity:d{>=0} joint_limits.*.min_velocity:d "
     "joint_limits.*.has_acceleration_limits:b=false joint_limits.*.max_acceleration:d{>=0} "
     "joint_limits.*.has_deceleration_limits:b joint_limits.*.max_deceleration:d "
     "joint_limits.*.has_jerk_limits:b=false joint_limits.*.max_jerk:d{>=0} "
     "cartesian_limits.max_trans_vel:d cartesian_limits.max_trans_acc:d "
     "cartesian_limits.max_trans_dec:d cartesian_limits.max_rot_vel:d"},
    {"kinematics.yaml",
     "*.kinematics_solver:s! *.kinematics_solver_search_resolution:d=0.1{>=0} "
     "*.kinematics_solver_timeout:d=0.05{>0} *.max_solver_iterations:i=500{>=0} "
     "*.epsilon:d=0.00001{>0} *.orientation_vs_position:d=1.0{>=0} *.position_only_ik:b=false"},
    {"moveit_controllers.yaml", "moveit_controller_manager:s moveit_manage_controllers:b "
                                "moveit_simple_controller_manager.controller_names:S! "
                                "moveit_simple_controller_manager.*.action_ns:s! "
                                "moveit_simple_controller_manager.*.type:s!"
                                "{one:FollowJointTrajectory,GripperCommand,ParallelGripperCommand} "
                                "moveit_simple_controller_manager.*.joints:S! "
                                "moveit_simple_controller_manager.*.default:b=false "
                                "moveit_simple_controller_manager.*.max_effort:d=0.0 "
                                "moveit_simple_controller_manager.*.max_velocity:d=0.0 "
                                "moveit_simple_controller_manager.*.parallel:b=false "
                                "moveit_simple_controller_manager.*.command_joint:s "
                                "moveit_simple_controller_manager.*.allow_failure:b=false "
                                "trajectory_execution.execution_duration_monitoring:b=true "
                                "trajectory_execution.allowed_execution_duration_scaling:d=1.1 "
                                "trajectory_execution.allowed_goal_duration_margin:d=0.5 "
                                "trajectory_execution.allowed_start_tolerance:d=0.01 "
                                "trajectory_execution.allowed_start_tolerance_joints.*:d "
                                "trajectory_execution.control_multi_dof_joint_variables:b=false "
                                "trajectory_execution.execution_velocity_scaling:d=1.0 "
                                "trajectory_execution.wait_for_trajectory_completion:b=true"},
    {"ompl_planning.yaml",
     "planning_plugins:S planning_plugin:s request_adapters:S response_adapters:S "
     "start_state_max_bounds_error:d planner_configs.*.type:s! *.planner_configs:S "
     "*.default_planner_config:s *.projection_evaluator:s "
     "*.longest_valid_segment_fraction:d=0.01 *.enforce_joint_model_state_space:b "
     "*.enforce_constrained_state_space:b"},
    {"sensors_3d.yaml",
     "sensors:S! octomap_resolution:d=0.1{>0} octomap_frame:s *.sensor_plugin:s! "
     "*.point_cloud_topic:s *.image_topic:s *.max_range:d *.padding_offset:d *.padding_scale:d "
     "*.point_subsample:i *.max_update_rate:d *.filtered_cloud_topic:s *.ns:s *.queue_size:i "
     "*.near_clipping_plane_distance:d *.far_clipping_plane_distance:d *.shadow_threshold:d "
     "*.skip_vertical_pixels:i *.skip_horizontal_pixels:i"},
};

/// Cuts from `rest` what is between `open` and `close`, if it begins with `open`.
std::string_view cut(std::string_view& rest, char open, std::string_view close) {
  if (rest.empty() || rest.front() != open) return {};
  const std::size_t end = std::min(rest.find_first_of(close, 1), rest.size());
  const std::string_view found = rest.substr(1, end - 1);
  const bool is_closed = open == '{' && end < rest.size();
  rest.remove_prefix(is_closed ? end + 1 : end);
  return found;
}

/// `path:type`, then `!` if the parameter must be set, `=` and the default, `{` conditions `}`, and
/// `@` and the distributions that have it, if not all. In a path, `*` is any name.
std::optional<RosParameter> parse(std::string_view word, std::string_view all) {
  const std::size_t colon = word.find(':');
  if (colon == std::string_view::npos || colon + 1 >= word.size()) return std::nullopt;
  RosParameter result;
  result.path = word.substr(0, colon);
  result.type = word[colon + 1];
  std::string_view rest = word.substr(colon + 2);
  result.is_required = rest.starts_with('!');
  if (result.is_required) rest.remove_prefix(1);
  result.fallback = cut(rest, '=', "{@");
  result.conditions = cut(rest, '{', "}");
  const std::string_view distributions = cut(rest, '@', "");
  result.distributions = distributions.empty() ? all : distributions;
  return result;
}

void append(std::string_view text, std::string_view all, std::vector<RosParameter>& to) {
  for (std::size_t at = 0;;) {
    const std::string_view word = next_word(text, at);
    if (word.empty()) return;
    if (const auto one = parse(word, all)) to.push_back(*one);
  }
}

/// Whether a path with `*` for a name fits a path.
bool fits(std::string_view pattern, std::string_view path) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return pattern == path;
  const std::string_view before = pattern.substr(0, star), after = pattern.substr(star + 1);
  return path.size() > before.size() + after.size() && path.starts_with(before) &&
         path.ends_with(after);
}

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find(at);
    if (!text.substr(0, end).empty()) parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

ValueCondition condition(std::string_view text) {
  using Kind = ValueCondition::Kind;
  const auto bounded = [&](Kind kind, std::size_t length) {
    return ValueCondition{kind, {}, parse_number(text.substr(length)).value_or(0)};
  };
  if (text.starts_with("one:")) return {Kind::one_of, split(text.substr(4), ','), 0};
  if (text.starts_with("of:")) return {Kind::one_of, split(text.substr(3), ','), 0};
  if (text.starts_with("size:")) return bounded(Kind::size, 5);
  if (text.starts_with(">=")) return bounded(Kind::at_least, 2);
  if (text.starts_with("<=")) return bounded(Kind::at_most, 2);
  if (text.starts_with(">")) return bounded(Kind::above, 1);
  if (text.starts_with("<")) return bounded(Kind::below, 1);
  return {Kind::unique, {}, 0};
}

}  // namespace

std::vector<ValueCondition> conditions_of(const RosParameter& parameter) {
  std::vector<ValueCondition> all;
  for (const std::string_view one : split(parameter.conditions, ';')) all.push_back(condition(one));
  return all;
}

std::string describe(const ValueCondition& condition) {
  const std::string bound = format_rounded(condition.bound);
  switch (condition.kind) {
  case ValueCondition::Kind::above: return "above " + bound;
  case ValueCondition::Kind::at_least: return "at least " + bound;
  case ValueCondition::Kind::below: return "below " + bound;
  case ValueCondition::Kind::at_most: return "at most " + bound;
  case ValueCondition::Kind::unique: return "each only once";
  case ValueCondition::Kind::size: return bound + " values";
  case ValueCondition::Kind::one_of: break;
  }
  return "one of " + listed(all_quoted(condition.texts));
}

const ControllerClass* find_controller_class(std::string_view type) {
  const std::span<const ControllerClass> all = controller_classes();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const ControllerClass& one) { return one.name == type; });
  return found == all.end() ? nullptr : &*found;
}

std::span<const MoveitFile> moveit_files() { return kMoveitFiles; }

const MoveitFile* find_moveit_file(std::string_view name) {
  const auto found = std::find_if(std::begin(kMoveitFiles), std::end(kMoveitFiles),
                                  [&](const MoveitFile& one) { return one.name == name; });
  return found == std::end(kMoveitFiles) ? nullptr : &*found;
}

std::vector<RosParameter> parameters_of(const ControllerClass& type) {
  std::vector<RosParameter> all;
  append(type.parameters, type.distributions, all);
  append(kCommon, type.distributions, all);
  return all;
}

std::vector<RosParameter> parameters_of(const MoveitFile& file) {
  std::vector<RosParameter> all;
  append(file.parameters, "hjkr", all);
  return all;
}

std::vector<RosParameter> manager_parameters() {
  std::vector<RosParameter> all;
  append(kManager, "hjkr", all);
  return all;
}

const RosParameter* find_parameter(const std::vector<RosParameter>& all, std::string_view path) {
  const RosParameter* found = nullptr;
  for (const RosParameter& one : all) {
    if (one.path == path) return &one;
    if (found == nullptr && fits(one.path, path)) found = &one;
  }
  return found;
}

std::string_view type_name(const RosParameter& parameter) {
  return parameter_type_name(parameter.type);
}

std::string_view parameter_type_name(char type) {
  switch (type) {
  case 'd': return "double";
  case 'i': return "integer";
  case 'b': return "bool";
  case 's': return "string";
  case 'D': return "list of doubles";
  case 'I': return "list of integers";
  case 'B': return "list of bools";
  case 'S': return "list of strings";
  default: return "value";
  }
}

std::string distribution_names(std::string_view distributions) {
  if (distributions == "hjkr") return {};
  std::vector<std::string_view> names;
  for (const char one : distributions) {
    names.push_back(one == 'h'   ? "Humble"
                    : one == 'j' ? "Jazzy"
                    : one == 'k' ? "Kilted"
                                 : "Rolling");
  }
  return enumerated(names);
}

}  // namespace smurf
