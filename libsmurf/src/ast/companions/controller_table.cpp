// SPDX-License-Identifier: BSD-3-Clause
// The parameters of the controllers of ros2_controllers. Source: the files *_parameters.yaml and
// *.yaml in its folders src and the plugin files, of the branches humble (ad559d9c), jazzy
// (ed360c97), kilted (0f8eb14e) and master (94e74de3), 2026-08.
#include "ast/ros_parameters.hpp"

namespace smurf {
namespace {

/// A class, the distributions that have it (h: Humble, j: Jazzy, k: Kilted, r: Rolling), those in
/// which it is chainable, and its parameters as parameters_of() reads them.
constexpr ControllerClass kClasses[] = {
    {"joint_trajectory_controller/JointTrajectoryController", "hjkr", "",
     "joints:S!{unique} command_joints:S{unique} "
     "command_interfaces:S!{unique;of:position,velocity,acceleration,effort} "
     "state_interfaces:S!{unique;of:position,velocity,acceleration} "
     "allow_partial_joints_goal:b=false open_loop_control:b=false@hj "
     "allow_integration_in_goal_trajectories:b=false state_publish_rate:d=50.0{>=0.1}@h "
     "set_last_command_interface_value_as_state_on_activation:b=true "
     "action_monitor_rate:d=20.0{>=0.1} interpolation_method:s=splines{one:splines,none} "
     "allow_nonzero_velocity_at_trajectory_end:b cmd_timeout:d=0.0 gains.*.p:d=0.0 "
     "gains.*.i:d=0.0 gains.*.d:d=0.0 gains.*.i_clamp:d@hj gains.*.ff_velocity_scale:d=0.0 "
     "gains.*.normalize_error:b=false@h gains.*.angle_wraparound:b=false@h "
     "constraints.stopped_velocity_tolerance:d=0.01 constraints.goal_time:d=0.0{>=0.0} "
     "constraints.*.trajectory:d=0.0 constraints.*.goal:d=0.0 "
     "speed_scaling.initial_scaling_factor:d=1.0{>=0.0}@jkr speed_scaling.state_interface:s@jkr "
     "speed_scaling.command_interface:s@jkr interpolate_from_desired_state:b=false@jkr "
     "gains.*.i_clamp_max:d@jkr gains.*.i_clamp_min:d@jkr gains.*.u_clamp_max:d@jkr "
     "gains.*.u_clamp_min:d@jkr gains.*.antiwindup_strategy:s@jkr "
     "gains.*.tracking_time_constant:d=0.0@jkr gains.*.error_deadband:d=0.0@jkr "
     "constraints.decelerate_on_cancel:b=false@jkr "
     "constraints.*.max_deceleration_on_cancel:d=0.0{>=0.0}@jkr "
     "allow_trajectory_replacement:b=true@r positions_upsampling.enable:b=false@r "
     "positions_upsampling.policy_frequency:d=0.0{>=0.0}@r"},
    {"diff_drive_controller/DiffDriveController", "hjkr", "jkr",
     "left_wheel_names:S! right_wheel_names:S! wheel_separation:d!{>0.0} wheels_per_side:i=0@h "
     "wheel_radius:d!{>0.0} wheel_separation_multiplier:d=1.0 left_wheel_radius_multiplier:d=1.0 "
     "right_wheel_radius_multiplier:d=1.0 tf_frame_prefix_enable:b=true tf_frame_prefix:s "
     "odom_frame_id:s=odom base_frame_id:s=base_link pose_covariance_diagonal:D "
     "twist_covariance_diagonal:D open_loop:b=false position_feedback:b=true "
     "enable_odom_tf:b=true cmd_vel_timeout:d=0.5 publish_limited_velocity:b=false "
     "velocity_rolling_window_size:i=10 use_stamped_vel:b=true@h publish_rate:d=50.0@hjk "
     "linear.x.has_velocity_limits:b@hj linear.x.has_acceleration_limits:b@hj "
     "linear.x.has_jerk_limits:b@hj linear.x.max_velocity:d linear.x.min_velocity:d "
     "linear.x.max_acceleration:d linear.x.min_acceleration:d@hj linear.x.max_jerk:d "
     "linear.x.min_jerk:d angular.z.has_velocity_limits:b@hj "
     "angular.z.has_acceleration_limits:b@hj angular.z.has_jerk_limits:b@hj "
     "angular.z.max_velocity:d angular.z.min_velocity:d angular.z.max_acceleration:d "
     "angular.z.min_acceleration:d@hj angular.z.max_jerk:d angular.z.min_jerk:d "
     "linear.x.max_deceleration:d@jkr linear.x.max_acceleration_reverse:d@jkr "
     "linear.x.max_deceleration_reverse:d@jkr angular.z.max_deceleration:d@jkr "
     "angular.z.max_acceleration_reverse:d@jkr angular.z.max_deceleration_reverse:d@jkr"},
    {"forward_command_controller/ForwardCommandController", "hjkr", "",
     "joints:S interface_name:s"},
    {"forward_command_controller/MultiInterfaceForwardCommandController", "hjkr", "",
     "joint:s interface_names:S"},
    {"joint_state_broadcaster/JointStateBroadcaster", "hjkr", "",
     "use_local_topics:b=false joints:S extra_joints:S interfaces:S "
     "map_interface_to_joint_state.position:s=position "
     "map_interface_to_joint_state.velocity:s=velocity "
     "map_interface_to_joint_state.effort:s=effort frame_id:s=base_link "
     "publish_dynamic_joint_states:b=true@hjk use_urdf_to_filter:b=true@jkr"},
    {"force_torque_sensor_broadcaster/ForceTorqueSensorBroadcaster", "hjkr", "jkr",
     "frame_id:s! sensor_name:s interface_names.force.x:s interface_names.force.y:s "
     "interface_names.force.z:s interface_names.torque.x:s interface_names.torque.y:s "
     "interface_names.torque.z:s offset.force.x:d=0.0@jkr offset.force.y:d=0.0@jkr "
     "offset.force.z:d=0.0@jkr offset.torque.x:d=0.0@jkr offset.torque.y:d=0.0@jkr "
     "offset.torque.z:d=0.0@jkr multiplier.force.x:d=1.0@jkr multiplier.force.y:d=1.0@jkr "
     "multiplier.force.z:d=1.0@jkr multiplier.torque.x:d=1.0@jkr multiplier.torque.y:d=1.0@jkr "
     "multiplier.torque.z:d=1.0@jkr"},
    {"imu_sensor_broadcaster/IMUSensorBroadcaster", "hjkr", "kr",
     "sensor_name:s! frame_id:s! static_covariance_orientation:D{size:9} "
     "static_covariance_angular_velocity:D{size:9} "
     "static_covariance_linear_acceleration:D{size:9} rotation_offset.roll:d=0.0@kr "
     "rotation_offset.pitch:d=0.0@kr rotation_offset.yaw:d=0.0@kr"},
    {"position_controllers/GripperActionController", "hj", "",
     "action_monitor_rate:d=20.0{>=0.1} joint:s goal_tolerance:d=0.01{>=0.0} "
     "max_effort:d=0.0{>=0.0} allow_stalling:b=false stall_velocity_threshold:d=0.001 "
     "stall_timeout:d=1.0"},
    {"effort_controllers/GripperActionController", "hj", "",
     "action_monitor_rate:d=20.0{>=0.1} joint:s goal_tolerance:d=0.01{>=0.0} "
     "max_effort:d=0.0{>=0.0} allow_stalling:b=false stall_velocity_threshold:d=0.001 "
     "stall_timeout:d=1.0"},
    {"parallel_gripper_action_controller/GripperActionController", "jkr", "",
     "action_monitor_rate:d=20.0{>=0.1} joint:s! state_interfaces:S=[position,velocity] "
     "goal_tolerance:d=0.01{>=0.0} allow_stalling:b=false stall_velocity_threshold:d=0.001 "
     "stall_timeout:d=1.0{>=0.0} max_effort_interface:s max_effort:d=10.0{>=0.0} "
     "max_velocity_interface:s max_velocity:d=0.1{>=0.0}"},
    {"admittance_controller/AdmittanceController", "hjkr", "hjkr",
     "joints:S! command_joints:S command_interfaces:S! state_interfaces:S! "
     "chainable_command_interfaces:S=[position,velocity] kinematics.plugin_name:s! "
     "kinematics.plugin_package:s! kinematics.base:s! kinematics.tip:s! kinematics.alpha:d=0.01 "
     "ft_sensor.name:s! ft_sensor.frame.id:s! ft_sensor.filter_coefficient:d=0.05 "
     "control.frame.id:s! fixed_world_frame.frame.id:s! gravity_compensation.frame.id:s! "
     "gravity_compensation.CoG.pos:D!{size:3} gravity_compensation.CoG.force:d=0.0 "
     "admittance.selected_axes:B!{size:6} admittance.mass:D!{size:6;each:0.0001,1000000.0} "
     "admittance.damping_ratio:D!{size:6} admittance.stiffness:D!{size:6;each:0.0,100000000.0} "
     "admittance.joint_damping:d=5.0{>=0.0} robot_description:s!@h "
     "enable_parameter_update_without_reactivation:b=true"},
    {"pid_controller/PidController", "hjkr", "hjkr",
     "dof_names:S!{unique} reference_and_state_dof_names:S{unique} command_interface:s! "
     "reference_and_state_interfaces:S! use_external_measured_states:b=false gains.*.p:d=0.0 "
     "gains.*.i:d=0.0 gains.*.d:d=0.0 gains.*.antiwindup:b=false@hj gains.*.i_clamp_max:d "
     "gains.*.i_clamp_min:d gains.*.feedforward_gain:d=0.0 gains.*.angle_wraparound:b=false "
     "set_current_state_as_first_setpoint:b=true@jkr enable_feedforward:b=false@j "
     "gains.*.u_clamp_max:d@jkr gains.*.u_clamp_min:d@jkr gains.*.antiwindup_strategy:s@jkr "
     "gains.*.tracking_time_constant:d=0.0@jkr gains.*.error_deadband:d=1e-16@jkr "
     "gains.*.save_i_term:b=true@jkr gains.*.activate_state_publisher:b=false@jkr"},
    {"gpio_controllers/GpioCommandController", "hjkr", "",
     "gpios:S!{unique} command_interfaces.*.interfaces:S{unique} "
     "state_interfaces.*.interfaces:S{unique}"},
    {"mecanum_drive_controller/MecanumDriveController", "hjkr", "hjkr",
     "reference_timeout:d=0.0 front_left_wheel_command_joint_name:s! "
     "front_right_wheel_command_joint_name:s! rear_right_wheel_command_joint_name:s! "
     "rear_left_wheel_command_joint_name:s! front_left_wheel_state_joint_name:s "
     "front_right_wheel_state_joint_name:s rear_right_wheel_state_joint_name:s "
     "rear_left_wheel_state_joint_name:s kinematics.base_frame_offset.x:d=0.0 "
     "kinematics.base_frame_offset.y:d=0.0 kinematics.base_frame_offset.theta:d=0.0 "
     "kinematics.wheels_radius:d!{>0.0} "
     "kinematics.sum_of_robot_center_projection_on_X_Y_axis:d=0.0 use_stamped_vel:b=true@h "
     "base_frame_id:s=base_link odom_frame_id:s=odom enable_odom_tf:b=true "
     "twist_covariance_diagonal:D pose_covariance_diagonal:D tf_frame_prefix_enable:b=true@jkr "
     "tf_frame_prefix:s@jkr linear.x.max_velocity:d@jkr linear.x.min_velocity:d@jkr "
     "linear.x.max_acceleration:d@jkr linear.x.max_deceleration:d@jkr "
     "linear.x.max_acceleration_reverse:d@jkr linear.x.max_deceleration_reverse:d@jkr "
     "linear.x.max_jerk:d@jkr linear.x.min_jerk:d@jkr linear.y.max_velocity:d@jkr "
     "linear.y.min_velocity:d@jkr linear.y.max_acceleration:d@jkr "
     "linear.y.max_deceleration:d@jkr linear.y.max_acceleration_reverse:d@jkr "
     "linear.y.max_deceleration_reverse:d@jkr linear.y.max_jerk:d@jkr linear.y.min_jerk:d@jkr "
     "angular.z.max_velocity:d@jkr angular.z.min_velocity:d@jkr angular.z.max_acceleration:d@jkr "
     "angular.z.max_deceleration:d@jkr angular.z.max_acceleration_reverse:d@jkr "
     "angular.z.max_deceleration_reverse:d@jkr angular.z.max_jerk:d@jkr angular.z.min_jerk:d@jkr"},
    {"omni_wheel_drive_controller/OmniWheelDriveController", "jkr", "jkr",
     "wheel_offset:d! wheel_names:S! robot_radius:d!{>0.0} wheel_radius:d!{>0.0} "
     "tf_frame_prefix_enable:b=true tf_frame_prefix:s odom_frame_id:s=odom "
     "base_frame_id:s=base_link diagonal_covariance.pose:D diagonal_covariance.twist:D "
     "open_loop:b=false position_feedback:b=true enable_odom_tf:b=true cmd_vel_timeout:d=0.5"},
    {"ackermann_steering_controller/AckermannSteeringController", "hjkr", "hjkr",
     "reference_timeout:d=1.0 front_steering:b=true@hj rear_wheels_names:S{unique}@hj "
     "front_wheels_names:S{unique}@hj rear_wheels_state_names:S{unique}@hj "
     "front_wheels_state_names:S{unique}@hj open_loop:b=false "
     "reduce_wheel_speed_until_steering_reached:b=false velocity_rolling_window_size:i=10 "
     "base_frame_id:s=base_link odom_frame_id:s=odom enable_odom_tf:b=true "
     "twist_covariance_diagonal:D pose_covariance_diagonal:D position_feedback:b=false "
     "use_stamped_vel:b=false@h front_wheel_track:d=0.0@hj rear_wheel_track:d=0.0@hj "
     "wheelbase:d!{>0.0} front_wheels_radius:d=0.0@hj rear_wheels_radius:d=0.0@hj "
     "traction_joints_names:S{unique}@jkr steering_joints_names:S{unique}@jkr "
     "traction_joints_state_names:S{unique}@jkr steering_joints_state_names:S{unique}@jkr "
     "steering_track_width:d=0.0@jkr traction_track_width:d=0.0@jkr "
     "traction_wheels_radius:d=0.0@jkr tf_frame_prefix:s@r"},
    {"bicycle_steering_controller/BicycleSteeringController", "hjkr", "hjkr",
     "reference_timeout:d=1.0 front_steering:b=true@hj rear_wheels_names:S{unique}@hj "
     "front_wheels_names:S{unique}@hj rear_wheels_state_names:S{unique}@hj "
     "front_wheels_state_names:S{unique}@hj open_loop:b=false "
     "reduce_wheel_speed_until_steering_reached:b=false velocity_rolling_window_size:i=10 "
     "base_frame_id:s=base_link odom_frame_id:s=odom enable_odom_tf:b=true "
     "twist_covariance_diagonal:D pose_covariance_diagonal:D position_feedback:b=false "
     "use_stamped_vel:b=false@h wheelbase:d!{>0.0} front_wheel_radius:d=0.0@hj "
     "rear_wheel_radius:d=0.0@hj traction_joints_names:S{unique}@jkr "
     "steering_joints_names:S{unique}@jkr traction_joints_state_names:S{unique}@jkr "
     "steering_joints_state_names:S{unique}@jkr traction_wheel_radius:d=0.0@jkr "
     "tf_frame_prefix:s@r"},
    {"tricycle_steering_controller/TricycleSteeringController", "hjkr", "hjkr",
     "reference_timeout:d=1.0 front_steering:b=true@hj rear_wheels_names:S{unique}@hj "
     "front_wheels_names:S{unique}@hj rear_wheels_state_names:S{unique}@hj "
     "front_wheels_state_names:S{unique}@hj open_loop:b=false "
     "reduce_wheel_speed_until_steering_reached:b=false velocity_rolling_window_size:i=10 "
     "base_frame_id:s=base_link odom_frame_id:s=odom enable_odom_tf:b=true "
     "twist_covariance_diagonal:D pose_covariance_diagonal:D position_feedback:b=false "
     "use_stamped_vel:b=false@h wheel_track:d=0.0@hj wheelbase:d!{>0.0} "
     "front_wheels_radius:d=0.0@hj rear_wheels_radius:d=0.0@hj "
     "traction_joints_names:S{unique}@jkr steering_joints_names:S{unique}@jkr "
     "traction_joints_state_names:S{unique}@jkr steering_joints_state_names:S{unique}@jkr "
     "traction_track_width:d=0.0@jkr traction_wheels_radius:d=0.0@jkr tf_frame_prefix:s@r"},
    {"tricycle_controller/TricycleController", "jkr", "",
     "traction_joint_name:s! steering_joint_name:s! wheelbase:d!{>0.0} wheel_radius:d!{>0.0} "
     "odom_frame_id:s=odom base_frame_id:s=base_link pose_covariance_diagonal:D "
     "twist_covariance_diagonal:D open_loop:b=false enable_odom_tf:b=false "
     "odom_only_twist:b=false cmd_vel_timeout:i=500 publish_ackermann_command:b=false "
     "velocity_rolling_window_size:i=10{>0} traction.max_velocity:d traction.min_velocity:d "
     "traction.max_acceleration:d traction.min_acceleration:d traction.max_deceleration:d "
     "traction.min_deceleration:d traction.max_jerk:d traction.min_jerk:d "
     "steering.max_position:d steering.min_position:d steering.max_velocity:d "
     "steering.min_velocity:d steering.max_acceleration:d steering.min_acceleration:d"},
    {"range_sensor_broadcaster/RangeSensorBroadcaster", "hjkr", "",
     "sensor_name:s frame_id:s radiation_type:i=0 field_of_view:d=0.52 min_range:d=0.52 "
     "max_range:d=4.0 variance:d=0.0@jkr"},
    {"pose_broadcaster/PoseBroadcaster", "hjkr", "",
     "frame_id:s! pose_name:s! tf.enable:b=true tf.child_frame_id:s "
     "tf.publish_rate:d=0.0{>=0.0}@hj"},
    {"gps_sensor_broadcaster/GPSSensorBroadcaster", "jkr", "",
     "sensor_name:s! frame_id:s! static_position_covariance:D{size:9} "
     "read_covariance_from_interface:b=false"},
    {"battery_state_broadcaster/BatteryStateBroadcaster", "jkr", "",
     "batteries:S!{unique} interfaces.*.battery_temperature:b=false "
     "interfaces.*.battery_current:b=false interfaces.*.battery_charge:b=false "
     "interfaces.*.battery_percentage:b=false interfaces.*.battery_power_supply_status:b=false "
     "interfaces.*.battery_power_supply_health:b=false interfaces.*.battery_present:b=false "
     "*.minimum_voltage:d *.maximum_voltage:d *.capacity:d *.design_capacity:d "
     "*.power_supply_technology:i=0{>=0;<=8} *.location:s *.serial_number:s sensor_name:s "
     "design_capacity:d power_supply_technology:i=0{>=0;<=8}"},
    {"magnetometer_broadcaster/MagnetometerBroadcaster", "jkr", "",
     "sensor_name:s! frame_id:s! static_covariance:D{size:9}"},
    {"motion_primitives_controllers/MotionPrimitivesForwardController", "jkr", "", "tf_prefix:s"},
    {"state_interfaces_broadcaster/StateInterfacesBroadcaster", "jkr", "", "interfaces:S!"},
    {"position_controllers/JointGroupPositionController", "hjk", "", "joints:S! interface_name:s"},
    {"velocity_controllers/JointGroupVelocityController", "hjk", "", "joints:S! interface_name:s"},
    {"effort_controllers/JointGroupEffortController", "hjk", "", "joints:S! interface_name:s"},
};

}  // namespace

std::span<const ControllerClass> controller_classes() { return kClasses; }

}  // namespace smurf
