// SPDX-License-Identifier: BSD-3-Clause
// What parameters of controllers and of MoveIt mean, for people who write them.
#include <algorithm>
#include <iterator>

#include "ast/ros_parameters.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

struct Sentence {
  std::string_view path;  ///< the end of a path, or the whole of it
  std::string_view text;
};

/// The first row whose path fits is used.
constexpr Sentence kSentences[] = {
    {"joint_limits.*.max_velocity",
     "The fastest motion that is planned, in rad/s or m/s; a double, so 1.0 and not 1."},
    {"joint_limits.*.max_acceleration", "The largest planned acceleration, in rad/s2 or m/s2."},
    {"joint_limits.*.max_jerk", "The largest planned jerk, in rad/s3 or m/s3."},
    {"joint_limits.*.max_position", "The upper limit of the position, in rad or m."},
    {"joint_limits.*.min_position", "The lower limit of the position, in rad or m."},
    {"has_velocity_limits", "Whether max_velocity counts."},
    {"has_acceleration_limits", "Whether max_acceleration counts."},
    {"has_jerk_limits", "Whether max_jerk counts."},
    {"default_velocity_scaling_factor", "The part of the velocity limits that plans use."},
    {"default_acceleration_scaling_factor", "The part of the acceleration limits that plans use."},
    {"kinematics_solver", "The plugin that computes joint positions from a pose."},
    {"kinematics_solver_search_resolution", "The step of a redundant joint in a search, in rad."},
    {"kinematics_solver_timeout", "The time for one solution, in seconds."},
    {"controller_names", "The controllers that MoveIt sends trajectories to."},
    {"action_ns", "The name of the action below the name of the controller."},
    {"moveit_simple_controller_manager.*.type", "The kind of action that the controller offers."},
    {"moveit_simple_controller_manager.*.default",
     "Whether this controller is preferred over others of the same joints."},
    {"parallel", "Whether two joints of a gripper move against each other."},
    {"allowed_execution_duration_scaling",
     "How many times longer than planned a motion may take before it is stopped."},
    {"allowed_goal_duration_margin", "Time beyond that, in seconds."},
    {"allowed_start_tolerance",
     "How far the robot may be from the first point of a trajectory, in rad or m."},
    {"projection_evaluator",
     "The joints or the link whose motion shows how much of the space was explored."},
    {"longest_valid_segment_fraction",
     "The part of the space between two checks for collisions; smaller is safer and slower."},
    {"default_planner_config", "The planner of the group, if a request names none."},
    {"planner_configs.*.type", "The planner of OMPL, such as geometric::RRTConnect."},
    {"sensors", "The names of the sensors; each has a mapping of its name in this file."},
    {"sensor_plugin", "The plugin that reads the sensor."},
    {"octomap_frame", "The link in whose frame the map of obstacles is built."},
    {"octomap_resolution", "The size of a cell of the map of obstacles, in m."},
    {"padding_offset", "How far the robot is enlarged before it is cut out of the map, in m."},
    {"max_range", "Points farther away are ignored, in m."},
    {"joints", "The joints that the controller uses, in this order."},
    {"command_joints", "The joints that it commands, if they are not all of `joints`."},
    {"command_interfaces", "The interfaces of each joint that the controller writes."},
    {"state_interfaces", "The interfaces of each joint that the controller reads."},
    {"gains.*.p", "The proportional gain of a joint."},
    {"gains.*.i", "The integral gain of a joint."},
    {"gains.*.d", "The derivative gain of a joint."},
    {"gains.*.ff_velocity_scale", "The part of the wanted velocity that is added to the command."},
    {"constraints.*.goal", "How far from the goal the joint may end, in rad or m; 0: anywhere."},
    {"constraints.*.trajectory",
     "How far from the path the joint may be, in rad or m; 0: anywhere."},
    {"constraints.goal_time", "How late the goal may be reached, in seconds; 0: at any time."},
    {"constraints.stopped_velocity_tolerance", "The velocity at which a joint counts as stopped."},
    {"open_loop_control", "Whether the last command counts as the state of the joints."},
    {"allow_partial_joints_goal", "Whether goals may name only some of the joints."},
    {"allow_nonzero_velocity_at_trajectory_end", "Whether a trajectory may end in motion."},
    {"action_monitor_rate", "How often the goal of an action is checked, in Hz."},
    {"state_publish_rate", "How often the state is published, in Hz."},
    {"interpolation_method", "How positions between two points of a trajectory are computed."},
    {"update_rate", "How often the controller runs, in Hz; an integer."},
    {"type", "The class, PACKAGE/CLASS."},
    {"left_wheel_names", "The joints of the left wheels."},
    {"right_wheel_names", "The joints of the right wheels."},
    {"wheel_separation", "The distance between the left and the right wheels, in m."},
    {"wheel_radius", "The radius of the wheels, in m."},
    {"odom_frame_id", "The frame that odometry is relative to."},
    {"base_frame_id", "The link whose motion is computed."},
    {"enable_odom_tf", "Whether the motion is also published as a transform."},
    {"cmd_vel_timeout", "After this time without a command, the robot stops, in seconds."},
    {"linear.x.max_velocity", "The fastest motion forwards, in m/s."},
    {"angular.z.max_velocity", "The fastest turn, in rad/s."},
    {"interface_name", "The interface of each joint that is commanded."},
    {"sensor_name", "The name of the sensor in `ros2_control`."},
    {"frame_id", "The link whose frame is written into messages."},
    {"goal_tolerance", "How far from its goal the gripper may end."},
    {"max_effort", "The largest force of the gripper."},
    {"dof_names", "The joints whose commands are computed."},
    {"command_interface", "The interface that is commanded."},
    {"use_sim_time", "Whether time comes from a simulation."},
};

bool ends_with(std::string_view path, std::string_view end) {
  if (!path.ends_with(end)) return false;
  return path.size() == end.size() || path[path.size() - end.size() - 1] == '.';
}

}  // namespace

std::string_view sentence_about(std::string_view path) {
  const auto found = std::find_if(std::begin(kSentences), std::end(kSentences),
                                  [&](const Sentence& one) { return ends_with(path, one.path); });
  return found == std::end(kSentences) ? std::string_view() : found->text;
}

bool holds_joints(std::string_view key) {
  return is_one_of(key, {"joints", "joint", "command_joints", "dof_names", "command_joint"}) ||
         key.ends_with("joint_name") || key.ends_with("joints_names") ||
         key.ends_with("joint_names") || key.ends_with("wheel_names") ||
         key.ends_with("wheels_names");
}

bool has_joints_as_keys(std::string_view path) {
  return is_one_of(path, {"gains", "constraints", "joint_limits",
                          "trajectory_execution.allowed_start_tolerance_joints"});
}

}  // namespace smurf
