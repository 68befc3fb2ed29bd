// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the controllers of ros2_controllers. Source: the files *_parameters.yaml and
// *.yaml in its folders src, of the branches humble, jazzy and master (94e74de, 2026-08).
#include "lint/companions/controller_tables.hpp"

#include <algorithm>

#include "base/words.hpp"

namespace smurf {
namespace {

/// A class, the distributions that have it (h: Humble, j: Jazzy, r: Rolling), and its parameters:
/// `path:type`, then `!` if the parameter must be set to something, then `@` and the distributions
/// that have it, if not all. In a path, `*` is any name. Types: d double, i integer, b boolean,
/// s text; capital letters are lists.
constexpr ControllerClass kClasses[] = {
    {"joint_trajectory_controller/JointTrajectoryController", "hjr",
     "joints:S! command_joints:S command_interfaces:S! state_interfaces:S! "
     "allow_partial_joints_goal:b open_loop_control:b@hj "
     "allow_integration_in_goal_trajectories:b state_publish_rate:d@h "
     "set_last_command_interface_value_as_state_on_activation:b action_monitor_rate:d "
     "interpolation_method:s allow_nonzero_velocity_at_trajectory_end:b cmd_timeout:d "
     "gains.*.p:d gains.*.i:d gains.*.d:d gains.*.i_clamp:d@hj gains.*.ff_velocity_scale:d "
     "gains.*.normalize_error:b@h gains.*.angle_wraparound:b@h "
     "constraints.stopped_velocity_tolerance:d constraints.goal_time:d "
     "constraints.*.trajectory:d constraints.*.goal:d "
     "speed_scaling.initial_scaling_factor:d@jr speed_scaling.state_interface:s@jr "
     "speed_scaling.command_interface:s@jr interpolate_from_desired_state:b@jr "
     "gains.*.i_clamp_max:d@jr gains.*.i_clamp_min:d@jr gains.*.u_clamp_max:d@jr "
     "gains.*.u_clamp_min:d@jr gains.*.antiwindup_strategy:s@jr "
     "gains.*.tracking_time_constant:d@jr gains.*.error_deadband:d@jr "
     "constraints.decelerate_on_cancel:b@jr constraints.*.max_deceleration_on_cancel:d@jr "
     "allow_trajectory_replacement:b@r positions_upsampling.enable:b@r "
     "positions_upsampling.policy_frequency:d@r"},
    {"diff_drive_controller/DiffDriveController", "hjr",
     "left_wheel_names:S! right_wheel_names:S! wheel_separation:d! wheels_per_side:i@h "
     "wheel_radius:d! wheel_separation_multiplier:d left_wheel_radius_multiplier:d "
     "right_wheel_radius_multiplier:d tf_frame_prefix_enable:b tf_frame_prefix:s "
     "odom_frame_id:s base_frame_id:s pose_covariance_diagonal:D twist_covariance_diagonal:D "
     "open_loop:b position_feedback:b enable_odom_tf:b cmd_vel_timeout:d "
     "publish_limited_velocity:b velocity_rolling_window_size:i use_stamped_vel:b@h "
     "publish_rate:d@hj linear.x.has_velocity_limits:b@hj "
     "linear.x.has_acceleration_limits:b@hj linear.x.has_jerk_limits:b@hj "
     "linear.x.max_velocity:d linear.x.min_velocity:d linear.x.max_acceleration:d "
     "linear.x.min_acceleration:d@hj linear.x.max_jerk:d linear.x.min_jerk:d "
     "angular.z.has_velocity_limits:b@hj angular.z.has_acceleration_limits:b@hj "
     "angular.z.has_jerk_limits:b@hj angular.z.max_velocity:d angular.z.min_velocity:d "
     "angular.z.max_acceleration:d angular.z.min_acceleration:d@hj angular.z.max_jerk:d "
     "angular.z.min_jerk:d linear.x.max_deceleration:d@jr "
     "linear.x.max_acceleration_reverse:d@jr linear.x.max_deceleration_reverse:d@jr "
     "angular.z.max_deceleration:d@jr angular.z.max_acceleration_reverse:d@jr "
     "angular.z.max_deceleration_reverse:d@jr"},
    {"forward_command_controller/ForwardCommandController", "hjr", "joints:S interface_name:s"},
    {"forward_command_controller/MultiInterfaceForwardCommandController", "hjr",
     "joint:s interface_names:S"},
    {"joint_state_broadcaster/JointStateBroadcaster", "hjr",
     "use_local_topics:b joints:S extra_joints:S interfaces:S "
     "map_interface_to_joint_state.position:s map_interface_to_joint_state.velocity:s "
     "map_interface_to_joint_state.effort:s frame_id:s publish_dynamic_joint_states:b@hj "
     "use_urdf_to_filter:b@jr"},
    {"force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster", "hjr",
     "frame_id:s! sensor_name:s interface_names.force.x:s interface_names.force.y:s "
     "interface_names.force.z:s interface_names.torque.x:s interface_names.torque.y:s "
     "interface_names.torque.z:s offset.force.x:d@jr offset.force.y:d@jr offset.force.z:d@jr "
     "offset.torque.x:d@jr offset.torque.y:d@jr offset.torque.z:d@jr multiplier.force.x:d@jr "
     "multiplier.force.y:d@jr multiplier.force.z:d@jr multiplier.torque.x:d@jr "
     "multiplier.torque.y:d@jr multiplier.torque.z:d@jr"},
    {"imu_sensor_broadcaster/IMUSensorBroadcaster", "hjr",
     "sensor_name:s! frame_id:s! static_covariance_orientation:D "
     "static_covariance_angular_velocity:D static_covariance_linear_acceleration:D "
     "rotation_offset.roll:d@r rotation_offset.pitch:d@r rotation_offset.yaw:d@r"},
    {"position_controllers/GripperActionController", "hj",
     "action_monitor_rate:d joint:s goal_tolerance:d max_effort:d allow_stalling:b "
     "stall_velocity_threshold:d stall_timeout:d"},
    {"effort_controllers/GripperActionController", "hj",
     "action_monitor_rate:d joint:s goal_tolerance:d max_effort:d allow_stalling:b "
     "stall_velocity_threshold:d stall_timeout:d"},
    {"parallel_gripper_action_controller/GripperActionController", "jr",
     "action_monitor_rate:d joint:s! state_interfaces:S goal_tolerance:d allow_stalling:b "
     "stall_velocity_threshold:d stall_timeout:d max_effort_interface:s max_effort:d "
     "max_velocity_interface:s max_velocity:d"},
    {"admittance_controller/AdmittanceController", "hjr",
     "joints:S! command_joints:S command_interfaces:S! state_interfaces:S! "
     "chainable_command_interfaces:S kinematics.plugin_name:s! kinematics.plugin_package:s! "
     "kinematics.base:s! kinematics.tip:s! kinematics.alpha:d ft_sensor.name:s! "
     "ft_sensor.frame.id:s! ft_sensor.filter_coefficient:d control.frame.id:s! "
     "fixed_world_frame.frame.id:s! gravity_compensation.frame.id:s! "
     "gravity_compensation.CoG.pos:D! gravity_compensation.CoG.force:d "
     "admittance.selected_axes:B! admittance.mass:D! admittance.damping_ratio:D! "
     "admittance.stiffness:D! admittance.joint_damping:d robot_description:s!@h "
     "enable_parameter_update_without_reactivation:b"},
    {"pid_controller/PidController", "hjr",
     "dof_names:S! reference_and_state_dof_names:S command_interface:s! "
     "reference_and_state_interfaces:S! use_external_measured_states:b gains.*.p:d "
     "gains.*.i:d gains.*.d:d gains.*.antiwindup:b@hj gains.*.i_clamp_max:d "
     "gains.*.i_clamp_min:d gains.*.feedforward_gain:d gains.*.angle_wraparound:b "
     "set_current_state_as_first_setpoint:b@jr enable_feedforward:b@j "
     "gains.*.u_clamp_max:d@jr gains.*.u_clamp_min:d@jr gains.*.antiwindup_strategy:s@jr "
     "gains.*.tracking_time_constant:d@jr gains.*.error_deadband:d@jr "
     "gains.*.save_i_term:b@jr gains.*.activate_state_publisher:b@jr"},
    {"gpio_controllers/GpioCommandController", "hjr",
     "gpios:S! command_interfaces.*.interfaces:S state_interfaces.*.interfaces:S"},
    {"mecanum_drive_controller/MecanumDriveController", "hjr",
     "reference_timeout:d front_left_wheel_command_joint_name:s! "
     "front_right_wheel_command_joint_name:s! rear_right_wheel_command_joint_name:s! "
     "rear_left_wheel_command_joint_name:s! front_left_wheel_state_joint_name:s "
     "front_right_wheel_state_joint_name:s rear_right_wheel_state_joint_name:s "
     "rear_left_wheel_state_joint_name:s kinematics.base_frame_offset.x:d "
     "kinematics.base_frame_offset.y:d kinematics.base_frame_offset.theta:d "
     "kinematics.wheels_radius:d! kinematics.sum_of_robot_center_projection_on_X_Y_axis:d "
     "use_stamped_vel:b@h base_frame_id:s odom_frame_id:s enable_odom_tf:b "
     "twist_covariance_diagonal:D pose_covariance_diagonal:D tf_frame_prefix_enable:b@jr "
     "tf_frame_prefix:s@jr linear.x.max_velocity:d@jr linear.x.min_velocity:d@jr "
     "linear.x.max_acceleration:d@jr linear.x.max_deceleration:d@jr "
     "linear.x.max_acceleration_reverse:d@jr linear.x.max_deceleration_reverse:d@jr "
     "linear.x.max_jerk:d@jr linear.x.min_jerk:d@jr linear.y.max_velocity:d@jr "
     "linear.y.min_velocity:d@jr linear.y.max_acceleration:d@jr "
     "linear.y.max_deceleration:d@jr linear.y.max_acceleration_reverse:d@jr "
     "linear.y.max_deceleration_reverse:d@jr linear.y.max_jerk:d@jr linear.y.min_jerk:d@jr "
     "angular.z.max_velocity:d@jr angular.z.min_velocity:d@jr angular.z.max_acceleration:d@jr "
     "angular.z.max_deceleration:d@jr angular.z.max_acceleration_reverse:d@jr "
     "angular.z.max_deceleration_reverse:d@jr angular.z.max_jerk:d@jr angular.z.min_jerk:d@jr"},
    {"omni_wheel_drive_controller/OmniWheelDriveController", "jr",
     "wheel_offset:d! wheel_names:S! robot_radius:d! wheel_radius:d! tf_frame_prefix_enable:b "
     "tf_frame_prefix:s odom_frame_id:s base_frame_id:s diagonal_covariance.pose:D "
     "diagonal_covariance.twist:D open_loop:b position_feedback:b enable_odom_tf:b "
     "cmd_vel_timeout:d"},
    {"ackermann_steering_controller/AckermannSteeringController", "hjr",
     "reference_timeout:d front_steering:b@hj rear_wheels_names:S@hj front_wheels_names:S@hj "
     "rear_wheels_state_names:S@hj front_wheels_state_names:S@hj open_loop:b "
     "reduce_wheel_speed_until_steering_reached:b velocity_rolling_window_size:i "
     "base_frame_id:s odom_frame_id:s enable_odom_tf:b twist_covariance_diagonal:D "
     "pose_covariance_diagonal:D position_feedback:b use_stamped_vel:b@h "
     "front_wheel_track:d@hj rear_wheel_track:d@hj wheelbase:d! front_wheels_radius:d@hj "
     "rear_wheels_radius:d@hj traction_joints_names:S@jr steering_joints_names:S@jr "
     "traction_joints_state_names:S@jr steering_joints_state_names:S@jr "
     "steering_track_width:d@jr traction_track_width:d@jr traction_wheels_radius:d@jr "
     "tf_frame_prefix:s@r"},
    {"bicycle_steering_controller/BicycleSteeringController", "hjr",
     "reference_timeout:d front_steering:b@hj rear_wheels_names:S@hj front_wheels_names:S@hj "
     "rear_wheels_state_names:S@hj front_wheels_state_names:S@hj open_loop:b "
     "reduce_wheel_speed_until_steering_reached:b velocity_rolling_window_size:i "
     "base_frame_id:s odom_frame_id:s enable_odom_tf:b twist_covariance_diagonal:D "
     "pose_covariance_diagonal:D position_feedback:b use_stamped_vel:b@h wheelbase:d! "
     "front_wheel_radius:d@hj rear_wheel_radius:d@hj traction_joints_names:S@jr "
     "steering_joints_names:S@jr traction_joints_state_names:S@jr "
     "steering_joints_state_names:S@jr traction_wheel_radius:d@jr tf_frame_prefix:s@r"},
    {"tricycle_steering_controller/TricycleSteeringController", "hjr",
     "reference_timeout:d front_steering:b@hj rear_wheels_names:S@hj front_wheels_names:S@hj "
     "rear_wheels_state_names:S@hj front_wheels_state_names:S@hj open_loop:b "
     "reduce_wheel_speed_until_steering_reached:b velocity_rolling_window_size:i "
     "base_frame_id:s odom_frame_id:s enable_odom_tf:b twist_covariance_diagonal:D "
     "pose_covariance_diagonal:D position_feedback:b use_stamped_vel:b@h wheel_track:d@hj "
     "wheelbase:d! front_wheels_radius:d@hj rear_wheels_radius:d@hj "
     "traction_joints_names:S@jr steering_joints_names:S@jr traction_joints_state_names:S@jr "
     "steering_joints_state_names:S@jr traction_track_width:d@jr traction_wheels_radius:d@jr "
     "tf_frame_prefix:s@r"},
    {"tricycle_controller/TricycleController", "jr",
     "traction_joint_name:s! steering_joint_name:s! wheelbase:d! wheel_radius:d! "
     "odom_frame_id:s base_frame_id:s pose_covariance_diagonal:D twist_covariance_diagonal:D "
     "open_loop:b enable_odom_tf:b odom_only_twist:b cmd_vel_timeout:i "
     "publish_ackermann_command:b velocity_rolling_window_size:i traction.max_velocity:d "
     "traction.min_velocity:d traction.max_acceleration:d traction.min_acceleration:d "
     "traction.max_deceleration:d traction.min_deceleration:d traction.max_jerk:d "
     "traction.min_jerk:d steering.max_position:d steering.min_position:d "
     "steering.max_velocity:d steering.min_velocity:d steering.max_acceleration:d "
     "steering.min_acceleration:d"},
    {"range_sensor_broadcaster/RangeSensorBroadcaster", "hjr",
     "sensor_name:s frame_id:s radiation_type:i field_of_view:d min_range:d max_range:d "
     "variance:d@jr"},
    {"pose_broadcaster/PoseBroadcaster", "hjr",
     "frame_id:s! pose_name:s! tf.enable:b tf.child_frame_id:s tf.publish_rate:d@hj"},
    {"gps_sensor_broadcaster/GPSSensorBroadcaster", "jr",
     "sensor_name:s! frame_id:s! static_position_covariance:D "
     "read_covariance_from_interface:b"},
    {"position_controllers/JointGroupPositionController", "hj", "joints:S! interface_name:s"},
    {"velocity_controllers/JointGroupVelocityController", "hj", "joints:S! interface_name:s"},
    {"effort_controllers/JointGroupEffortController", "hj", "joints:S! interface_name:s"},
};

/// Parameters of all controllers: controller_interface, rclcpp.
constexpr std::string_view kCommon =
    "type:s update_rate:i is_async:b thread_priority:i use_sim_time:b params_file:s "
    "fallback_controllers:S async_parameters.scheduling_policy:s "
    "async_parameters.cpu_affinity:I async_parameters.thread_priority:i "
    "async_parameters.wait_until_initial_trigger:b async_parameters.print_warnings:b";

std::optional<Parameter> parse(std::string_view word, std::string_view all) {
  const std::size_t colon = word.find(':');
  if (colon == std::string_view::npos || colon + 1 >= word.size()) return std::nullopt;
  Parameter result{word.substr(0, colon), word[colon + 1], false, all};
  std::string_view rest = word.substr(colon + 2);
  result.is_required = rest.starts_with('!');
  const std::size_t at = rest.find('@');
  if (at != std::string_view::npos) result.distributions = rest.substr(at + 1);
  return result;
}

void append(std::string_view text, std::string_view all, std::vector<Parameter>& to) {
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

}  // namespace

const ControllerClass* find_controller_class(std::string_view type) {
  const auto found = std::find_if(std::begin(kClasses), std::end(kClasses),
                                  [&](const ControllerClass& one) { return one.name == type; });
  return found == std::end(kClasses) ? nullptr : &*found;
}

std::vector<std::string_view> controller_class_names() {
  std::vector<std::string_view> names;
  for (const ControllerClass& one : kClasses) names.push_back(one.name);
  return names;
}

std::vector<Parameter> parameters_of(const ControllerClass& type) {
  std::vector<Parameter> all;
  append(type.parameters, type.distributions, all);
  append(kCommon, type.distributions, all);
  return all;
}

const Parameter* find_parameter(const std::vector<Parameter>& all, std::string_view path) {
  const Parameter* found = nullptr;
  for (const Parameter& one : all) {
    if (one.path == path) return &one;
    if (found == nullptr && fits(one.path, path)) found = &one;
  }
  return found;
}

}  // namespace smurf
