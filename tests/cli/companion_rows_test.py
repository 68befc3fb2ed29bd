# SPDX-License-Identifier: BSD-3-Clause
"""Each mistake that a reader of SRDF, ros2_control, controllers or MoveIt files knows, in a robot that is otherwise clean.

A row names the part, the file, what is written instead of what, the rule, words of its message, and the file of the finding if that is
another one. It must be the only finding of these rules.
"""
import json
import pathlib
import re
import sys
import textwrap

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "verdicts"))
import cli  # noqa: E402
import companion_damage  # noqa: E402
import companion_tables  # noqa: E402

ROBOT = companion_damage.ROBOT + companion_damage.HARDWARE.split("<robot>\n")[1]
CONTROLLERS = """controller_manager:
  ros__parameters:
    update_rate: 100
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
    spin: {type: velocity_controllers/JointGroupVelocityController}
    force: {type: joint_trajectory_controller/JointTrajectoryController}
    base: {type: diff_drive_controller/DiffDriveController}
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
arm:
  ros__parameters:
    joints: [shoulder]
    command_interfaces: [position]
    state_interfaces: [position]
    update_rate: 50
    constraints:
      goal_time: 0.5
      shoulder: {goal: 0.1}
spin:
  ros__parameters:
    joints: [elbow]
force:
  ros__parameters:
    joints: [wrist]
    command_interfaces: [effort]
    state_interfaces: [position, velocity]
    gains:
      wrist: {p: 1.0}
base:
  ros__parameters:
    left_wheel_names: [elbow]
    right_wheel_names: [elbow]
    wheel_separation: 0.4
    wheel_radius: 0.1
states:
  ros__parameters: {}
"""
FILES = {
    "robot": ("lamp_description/urdf/lamp.urdf", ROBOT.replace('name="wrist" type="revolute"', 'name="wrist" type="continuous"').replace(
        '<command_interface name="effort"/>', '<command_interface name="effort"/>\n      <command_interface name="velocity"/>').replace(
        '<state_interface name="effort"/>', '<state_interface name="position"/>\n      <state_interface name="velocity"/>\n'
        '      <state_interface name="effort"/>')),
    "srdf": ("lamp_moveit_config/config/lamp.srdf", companion_damage.SRDF.replace(
        'link1="base" link2="upper" reason="Adjacent"', 'link1="upper" link2="lower" reason="Adjacent"').replace(
        "</robot>", "".join(f'  <disable_collisions link1="{a}" link2="{b}" reason="Adjacent"/>\n' for a, b in (
            ("lower", "hand"), ("hand", "finger"), ("hand", "thumb"), ("upper", "eye"))) + "</robot>")),
    "controllers": ("lamp_moveit_config/config/ros2_controllers.yaml", CONTROLLERS),
    "limits": ("lamp_moveit_config/config/joint_limits.yaml", """default_velocity_scaling_factor: 0.1
joint_limits:
  shoulder:
    has_velocity_limits: true
    max_velocity: 1.5
    has_acceleration_limits: false
    has_position_limits: true
    min_position: -0.9
    max_position: 0.9
"""),
    "kinematics": ("lamp_moveit_config/config/kinematics.yaml", """arm:
  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin
  kinematics_solver_search_resolution: 0.005
  kinematics_solver_timeout: 0.05
"""),
    "moveit": ("lamp_moveit_config/config/moveit_controllers.yaml", """moveit_simple_controller_manager:
  controller_names: [arm]
  arm:
    action_ns: follow_joint_trajectory
    type: FollowJointTrajectory
    joints: [shoulder]
"""),
    "ompl": ("lamp_moveit_config/config/ompl_planning.yaml", """planner_configs:
  RRT: {type: geometric::RRT}
arm:
  planner_configs: [RRT]
"""),
    "sensors": ("lamp_moveit_config/config/sensors_3d.yaml", """sensors: [camera]
camera:
  sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater
"""),
    "setup": ("lamp_moveit_config/.setup_assistant", """moveit_setup_assistant_config:
  urdf: {package: lamp_description, relative_path: urdf/lamp.urdf}
  srdf: {relative_path: config/lamp.srdf}
"""),
}
NAMELESS = (("ros2_control", '<ros2_control name="arm" ', "<ros2_control "), ("joint", '<joint name="elbow">', "<joint>"),
            ("sensor", '<sensor name="force">', "<sensor>"), ("gpio", '<gpio name="lights">', "<gpio>"),
            ("interface", '<state_interface name="force.x"/>', "<state_interface/>"),
            ("parameter", '<param name="bus">', "<param>"))
WRIST = '<joint name="wrist">\n      <command_interface name="effort"/>'
EFFORT = '<joint name="wrist">\n      <command_interface name="effort">\n        <param name="max">{}</param>\n      </command_interface>'
GRIP = ('<joint name="grip">\n      <limits enable="true"/>\n      <command_interface name="position"/>\n'
        '      <state_interface name="position" data_type="double" size="1"/>\n    </joint>\n')
GEAR = ('<transmission name="gear">\n      <plugin>transmission_interface/SimpleTransmission</plugin>\n      <joint name="wrist" role="a"/>\n'
        '      <joint name="wrist" role="b"/>\n      <actuator name="motor" role="c"/>\n    </transmission>\n    ')
FORCE = "joints: [wrist]\n    command_interfaces: [effort]\n    state_interfaces: [position, velocity]\n    gains:\n      wrist: {p: 1.0}\n"
ARM = CONTROLLERS[CONTROLLERS.index("arm:\n  ros"):CONTROLLERS.index("spin:\n  ros")]
ROWS = [
    # SRDF
    ("robot: another name", "srdf", '<robot name="lamp">', '<robot name="lantern">', "SML3502", "calls it `lamp`"),
    ("virtual_joint: no type", "srdf", 'name="world_joint" type="fixed" ', 'name="world_joint" ', "SML3503", "has no `type`"),
    ("virtual_joint: no parent_frame", "srdf", ' parent_frame="world"', "", "SML3503", "has no `parent_frame`"),
    ("virtual_joint: unknown link", "srdf", 'child_link="base"', 'child_link="bass"', "SML3501", "the link `bass`"),
    ("virtual_joint: not the root", "srdf", 'child_link="base"', 'child_link="hand"', "SML3506", "not the root"),
    ("virtual_joint: unknown type", "srdf", 'type="fixed"', 'type="flaoting"', "SML3505", "flaoting"),
    ("group: no name", "srdf", '<group name="all">', "<group>", "SML3503", "`group` has no `name`"),
    ("group: unknown link", "srdf", '<link name="finger"/>', '<link name="fingr"/>', "SML3501", "the link `fingr`"),
    ("group: unknown joint", "srdf", '<joint name="squeeze"/>', '<joint name="squeze"/>', "SML3501", "the joint `squeze`"),
    ("group: unknown end of a chain", "srdf", 'tip_link="hand"', 'tip_link="hnd"', "SML3501", "the link `hnd`"),
    ("group: no end of a chain", "srdf", ' tip_link="hand"', "", "SML3503", "has no `tip_link`"),
    ("group: chain the wrong way round", "srdf", 'base_link="base" tip_link="hand"', 'base_link="hand" tip_link="base"', "SML3507", "wrong way"),
    ("group: unknown subgroup", "srdf", '<group name="gripper"/>', '<group name="griper"/>', "SML3501", "the group `griper`"),
    ("group: contains itself", "srdf", '<group name="gripper"/>', '<group name="all"/>', "SML3509", "contains itself"),
    ("group: twice", "srdf", '<group name="all">', '<group name="gripper">\n    <link name="thumb"/>\n  </group>\n  <group name="all">', "SML3508", "already"),
    ("group: empty", "srdf", '<group name="all">', '<group name="none">\n  </group>\n  <group name="all">', "SML3510", "no members"),
    ("group: a chain of one link", "srdf", '<group name="all">', '<group name="none">\n    <chain base_link="hand" tip_link="hand"/>\n  </group>\n  <group name="all">', "SML3510", "no joint"),
    ("group: other elements", "srdf", '<joint name="squeeze"/>', '<joint name="squeeze"/>\n    <passive_joint name="squeeze"/>', "SML3504", "in `group`"),
    ("group_state: unknown group", "srdf", 'name="up" group="arm"', 'name="up" group="amr"', "SML3501", "the group `amr`"),
    ("group_state: no group", "srdf", 'name="up" group="arm"', 'name="up"', "SML3503", "has no `group`"),
    ("group_state: unknown joint", "srdf", '<joint name="elbow" value', '<joint name="elbo" value', "SML3501", "the joint `elbo`"),
    ("group_state: a word", "srdf", 'value="0.2"', 'value="bent"', "SML3511", "not a number"),
    ("group_state: a comma", "srdf", 'value="0.2"', 'value="0,2"', "SML3511", "not a number"),
    ("group_state: empty", "srdf", 'value="0.2"', 'value=""', "SML3511", "empty"),
    ("group_state: two numbers", "srdf", 'value="0.2"', 'value="0.2 0.3"', "SML3511", "2 values"),
    ("group_state: joint of another group", "srdf", '<joint name="elbow" value', '<joint name="grip" value', "SML3512", "not in the group"),
    ("group_state: beyond the limits", "srdf", 'value="0.2"', 'value="1.2"', "SML3513", "beyond its limits"),
    ("group_state: a mimic joint", "srdf", "<end_effector", '<group_state name="shut" group="gripper">\n    <joint name="grip" value="0"/>\n    <joint name="squeeze" value="0"/>\n'
     "  </group_state>\n  <end_effector", "SML3514", "follows `grip`"),
    ("group_state: a fixed joint", "srdf", "<end_effector", '<group name="look">\n    <joint name="wrist"/>\n    <joint name="mount"/>\n  </group>\n'
     '  <group_state name="see" group="look">\n    <joint name="wrist" value="0"/>\n    <joint name="mount" value="0"/>\n  </group_state>\n'
     "  <end_effector", "SML3514", "fixed"),
    ("group_state: a joint is missing", "srdf", '    <joint name="wrist" value="0.3"/>\n', "", "SML3515", "does not set `wrist`"),
    ("end_effector: no group", "srdf", 'name="tool" group="gripper"', 'name="tool"', "SML3503", "has no `group`"),
    ("end_effector: unknown group", "srdf", 'name="tool" group="gripper"', 'name="tool" group="griper"', "SML3501", "the group `griper`"),
    ("end_effector: unknown link", "srdf", 'parent_link="hand"', 'parent_link="hnd"', "SML3501", "the link `hnd`"),
    ("end_effector: no parent_link", "srdf", ' parent_link="hand"', "", "SML3503", "has no `parent_link`"),
    ("end_effector: unknown parent group", "srdf", 'parent_group="arm"', 'parent_group="amr"', "SML3501", "the group `amr`"),
    ("end_effector: its own parent", "srdf", 'parent_group="arm"', 'parent_group="gripper"', "SML3516", "own group"),
    ("end_effector: parent link outside of the parent group", "srdf", 'parent_link="hand"', 'parent_link="eye"', "SML3516", "not in its parent group"),
    ("end_effector: parent link in its own group", "srdf", 'parent_link="hand" parent_group="arm"', 'parent_link="finger"', "SML3516", "its own group"),
    ("end_effector: shares joints with its parent group", "srdf", 'parent_group="arm"', 'parent_group="all"', "SML3516", "also moves `grip`"),
    ("disable_collisions: unknown link", "srdf", 'link2="hand" reason="Never"', 'link2="hnd" reason="Never"', "SML3501", "the link `hnd`"),
    ("disable_collisions: no link", "srdf", ' link2="hand" reason="Never"', ' reason="Never"', "SML3503", "has no `link2`"),
    ("enable_collisions: unknown link", "srdf", 'link1="eye" link2="hand"', 'link1="eye" link2="hnd"', "SML3501", "the link `hnd`"),
    ("disable_default_collisions: unknown link", "srdf", '<disable_default_collisions link="eye"/>', '<disable_default_collisions link="eyes"/>', "SML3501", "the link `eyes`"),
    ("disable_collisions: twice", "srdf", "</robot>", '  <disable_collisions link1="hand" link2="upper" reason="Never"/>\n</robot>', "SML3517", "here again"),
    ("disable_collisions: with itself", "srdf", 'link1="upper" link2="hand"', 'link1="upper" link2="upper"', "SML3517", ""),
    ("disable_collisions: neighbours are missing", "srdf", '  <disable_collisions link1="lower" link2="hand" reason="Adjacent"/>\n', "", "SML3520", "neighbours"),
    ("passive_joint: unknown joint", "srdf", '<passive_joint name="squeeze"/>', '<passive_joint name="squeeeze"/>', "SML3501", "the joint `squeeeze`"),
    ("joint_property: unknown joint", "srdf", 'joint_name="wrist"', 'joint_name="wirst"', "SML3501", "the joint `wirst`"),
    ("joint_property: unknown property", "srdf", "angular_distance_weight", "angular_distance_wieght", "SML3518", "does not know the property"),
    ("joint_property: unknown motion model", "srdf", '"angular_distance_weight" value="0.5"', '"motion_model" value="diffdrive"', "SML3518", "not a motion model"),
    ("joint_property: text behind the number", "srdf", '"angular_distance_weight" value="0.5"', '"angular_distance_weight" value="0.5 m"', "SML3518", "not a number"),
    ("link_sphere_approximation: unknown link", "srdf", '<link_sphere_approximation link="upper">', '<link_sphere_approximation link="uper">', "SML3501", "the link `uper`"),
    ("link_sphere_approximation: wrong center", "srdf", 'center="0 0 0.1"', 'center="0 0"', "SML3519", "`center`"),
    ("link_sphere_approximation: wrong radius", "srdf", 'radius="0.05"', 'radius="0,05"', "SML3519", "`radius`"),
    ("unknown element", "srdf", "<passive_joint ", "<pasive_joint ", "SML3504", "pasive_joint"),
    ("unknown attribute", "srdf", 'link2="hand" reason="Never"', 'link2="hand" resaon="Never"', "SML3504", "resaon"),
    # ros2_control
    *[(f"{name}: no name", "robot", old, new, "SML3601", "has no `name`") for name, old, new in NAMELESS],
    ("ros2_control: no type", "robot", '<ros2_control name="wrist" type="actuator">', '<ros2_control name="wrist">', "SML3601", "has no `type`"),
    ("ros2_control: other elements", "robot", '<gpio name="lights">', '<note/>\n    <gpio name="lights">', "SML3602", "unknown element `note`"),
    ("hardware: no plugin", "robot", "<plugin>lamp_hardware/Arm</plugin>", "<plugins>lamp_hardware/Arm</plugins>", "SML3601", "no `plugin`"),
    ("joint: other elements", "robot", '<state_interface name="position" data_type="double" size="1"/>', '<state_interface name="position"/>\n      <comand_interface name="effort"/>', "SML3602", "comand_interface"),
    ("interface: other elements", "robot", '<param name="max">1.5</param>', '<params name="max">1.5</params>', "SML3602", "params"),
    ("ros2_control: unknown type", "robot", 'name="arm" type="system"', 'name="arm" type="systm"', "SML3603", "systm"),
    ("ros2_control: two of one name", "robot", '<ros2_control name="wrist"', '<ros2_control name="arm"', "SML3603", "already"),
    ("joint: not in the robot", "robot", '<joint name="elbow">\n      <command', '<joint name="elbo">\n      <command', "SML3604", "`elbo`"),
    ("joint: fixed", "robot", '<gpio name="lights">', '<joint name="mount">\n      <state_interface name="position"/>\n    </joint>\n    <gpio name="lights">', "SML3604", "fixed"),
    ("joint: commanded and mimics", "robot", '<joint name="squeeze" mimic="true">', '<joint name="squeeze">\n      <command_interface name="position"/>', "SML3605", "command interface"),
    ("joint: mimics no other", "robot", '<joint name="elbow">\n      <command', '<joint name="elbow" mimic="true">\n      <command', "SML3605", "mimics no other"),
    ("disable_collisions: no collision geometry", "srdf", 'link1="upper" link2="hand"', 'link1="base" link2="hand"', "SML3517", "no collision geometry"),
    ("joint: follows a joint of another block", "robot", GRIP, "", "SML3605", "does not have"),
    ("joint: mimic is no truth value", "robot", 'mimic="true"', 'mimic="1"', "SML3606", "`mimic`"),
    ("ros2_control: is_async is no truth value", "robot", 'is_async="true"', 'is_async="yes"', "SML3606", "`is_async`"),
    ("limits: enable is no truth value", "robot", '<limits enable="true"/>', '<limits enable="on"/>', "SML3606", "`enable`"),
    ("gpio: size is no positive integer", "robot", 'size="2"', 'size="0"', "SML3606", "`size`"),
    ("ros2_control: thread_priority is no positive integer", "robot", 'thread_priority="40"', 'thread_priority="high"', "SML3606", "`thread_priority`"),
    ("ros2_control: rw_rate is a text", "robot", 'rw_rate="100"', 'rw_rate="fast"', "SML3606", "`rw_rate`"),
    ("ros2_control: rw_rate is negative", "robot", 'rw_rate="100"', 'rw_rate="-5"', "SML3606", "`rw_rate`"),
    ("interface: limit is not a number", "robot", '<param name="max">1.5</param>', '<param name="max">{2*pi}</param>', "SML3607", "not a number"),
    ("interface: limit is wider than the joint's", "robot", '<param name="max">0.9</param>', '<param name="max">1.9</param>', "SML3607", "beyond the limits of the joint"),
    ("interface: limits of a continuous joint", "robot", WRIST, '<joint name="wrist">\n      <command_interface name="position">\n        <param name="min">-3</param>\n'
     '      </command_interface>\n      <command_interface name="effort"/>', "SML3607", "continuous"),
    ("interface: effort is higher than the joint's", "robot", WRIST, EFFORT.format(50), "SML3607", ""),
    ("interface: effort limit 0", "robot", WRIST, EFFORT.format(0), "SML3607", ""),
    ("actuator: two joints in a transmission", "robot", WRIST, GEAR + WRIST, "SML3609", "exactly one"),
    ("interface: limit of another quantity", "robot", WRIST, WRIST.replace('"/>', '"/>\n      <command_interface name="damping">\n        <param name="max">1.5</param>\n'
     "      </command_interface>"), "SML3607", "does not apply"),
    ("interface: min above max", "robot", '<param name="min">-0.9</param>', '<param name="min">0.95</param>', "SML3607", "above its `max`"),
    ("interface: initial value beyond the limits", "robot", '<param name="initial_value">0.1</param>', '<param name="initial_value">0.95</param>', "SML3607", "initial value"),
    ("interface: initial value is not a number", "robot", '<param name="initial_value">0.1</param>', '<param name="initial_value">zero</param>', "SML3607", "not a number"),
    ("interface: near miss of a standard name", "robot", '<state_interface name="position" data_type="double" size="1"/>', '<state_interface name="positon"/>', "SML3608", "positon"),
    ("interface: commanded without a state", "robot", '\n      <state_interface name="position" data_type="double" size="1"/>', "", "SML3608", "no state interface"),
    ("interface: twice", "robot", '<state_interface name="position" data_type="double" size="1"/>', '<state_interface name="position"/>\n      <state_interface name="position"/>', "SML3608", "twice"),
    ("transmission: joint of no block", "robot", '<joint name="shoulder" role="joint1">', '<joint name="wrist" role="joint1">', "SML3609", "`wrist`"),
    ("transmission: no plugin", "robot", "      <plugin>transmission_interface/SimpleTransmission</plugin>\n", "", "SML3601", "no `plugin`"),
    ("hardware: plugin is empty", "robot", "<plugin>lamp_hardware/Arm</plugin>", "<plugin></plugin>", "SML3601", "plugin"),
    ("two blocks command one joint", "robot", '<joint name="wrist">\n      <command_interface name="effort"/>', '<joint name="shoulder">\n      <command_interface name="position"/>', "SML3610", "too"),
    ("transmission of ROS 1", "robot", '<ros2_control name="wrist"', '<transmission name="old">\n    <type>transmission_interface/SimpleTransmission</type>\n    <joint name="wrist">\n'
     "      <hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>\n    </joint>\n    <actuator name=\"m\"/>\n  </transmission>\n  <ros2_control name=\"wrist\"", "SML3614", "ROS 1"),
    ("interface: velocity is higher than the joint's", "robot", '<command_interface name="velocity"/>', '<command_interface name="velocity">\n        <param name="max">2.5</param>\n'
     "      </command_interface>", "SML3607", "above the limit"),
    ("interface: min of a jerk", "robot", WRIST, WRIST.replace('"/>', '"/>\n      <command_interface name="jerk">\n        <param name="min">-9</param>\n'
     "      </command_interface>"), "SML3607", "only applies its `max`"),
    ("Gazebo: no plugin", "robot", "<plugin>lamp_hardware/Wrist</plugin>", "<plugin>gz_ros2_control/GazeboSimSystem</plugin>", "SML3613", "plugin"),
    # controllers
    ("controller: no type", "controllers", "    states: {type: joint_state_broadcaster/JointStateBroadcaster}\n", "    states: {update_rate: 50}\n", "SML3704", "no `type`"),
    ("controller: unknown type", "controllers", "joint_state_broadcaster/JointStateBroadcaster", "joint_state_broadcaster/JointStatBroadcaster", "SML3704", "unknown type"),
    ("controller: no section", "controllers", "arm:\n  ros__parameters:\n    joints: [shoulder]", "arm2:\n  ros__parameters:\n    joints: [shoulder]", "SML3704", "no section"),
    ("controller: no joints", "controllers", "    joints: [shoulder]\n", "", "SML3704", "`joints`"),
    ("controller: joint twice", "controllers", "joints: [shoulder]", "joints: [shoulder, shoulder]", "SML3710", "twice"),
    ("controller: no wheels", "controllers", "left_wheel_names: [elbow]", "left_wheel_names: []", "SML3704", "`left_wheel_names`"),
    ("controller: wheel_separation 0", "controllers", "wheel_separation: 0.4", "wheel_separation: 0.0", "SML3710", "above 0"),
    ("controller: wheel_radius 0", "controllers", "wheel_radius: 0.1", "wheel_radius: 0.0", "SML3710", "above 0"),
    ("controller: integer for a double", "controllers", "goal_time: 0.5", "goal_time: 1", "SML3702", "must be a double"),
    ("controller: text for a number", "controllers", "goal_time: 0.5", 'goal_time: "0.5"', "SML3702", "must be a double"),
    ("controller: unknown key", "controllers", "goal_time: 0.5", "goal_tme: 0.5", "SML3703", "goal_tme"),
    ("controller: unknown joint", "controllers", "joints: [shoulder]", "joints: [sholder]", "SML3701", "`sholder`"),
    ("controller: command interface that no joint offers", "controllers", "joints: [wrist]\n    command_interfaces: [effort]", "joints: [wrist]\n    command_interfaces: [position]", "SML3705", "`position`"),
    ("controller: state interface that no joint offers", "controllers", "state_interfaces: [position]\n", "state_interfaces: [position, velocity]\n", "SML3705", "`velocity`"),
    ("controller: commands that do not go together", "controllers", "command_interfaces: [effort]", "command_interfaces: [effort, velocity]", "SML3706", "do not go together"),
    ("controller: states that do not go together", "controllers", "state_interfaces: [position, velocity]", "state_interfaces: [velocity]", "SML3706", ""),
    ("controller: effort without velocity states", "controllers", "state_interfaces: [position, velocity]", "state_interfaces: [position]", "SML3706", ""),
    ("controller: chained to nothing", "controllers", "joints: [wrist]\n", "joints: [wrist]\n    command_joints: [basee/wrist]\n", "SML3708", "no controller `basee`"),
    ("controller: chained to one that takes no commands", "controllers", "joints: [wrist]\n", "joints: [wrist]\n    command_joints: [states/wrist]\n", "SML3708", "not chainable"),
    ("controller: velocity without velocity states", "controllers", "command_interfaces: [effort]\n    state_interfaces: [position, velocity]",
     "command_interfaces: [velocity]\n    state_interfaces: [position]", "SML3706", "`state_interfaces`"),
    ("controller: no gains", "controllers", "    gains:\n      wrist: {p: 1.0}\n", "", "SML3706", "without gains"),
    ("controller: update_rate of the manager", "controllers", "update_rate: 100", "update_rate: 0", "SML3707", ""),
    ("controller: rate above the manager's", "controllers", "update_rate: 50", "update_rate: 200", "SML3707", "more than"),
    ("controller: rate that does not divide", "controllers", "update_rate: 50", "update_rate: 30", "SML3707", "does not divide"),
    ("controller: constraints of no joint", "controllers", "shoulder: {goal: 0.1}", "sholder: {goal: 0.1}", "SML3701", "`sholder`"),
    ("controller: gains of no joint", "controllers", "wrist: {p: 1.0}", "wrist: {p: 1.0}\n      wirst: {p: 1.0}", "SML3701", "`wirst`"),
    ("controller: an acceleration alone", "controllers", "command_interfaces: [position]\n", "command_interfaces: [acceleration]\n", "SML3706", "do not go together"),
    ("controller: a state that it does not know", "controllers", "state_interfaces: [position]\n", "state_interfaces: [position, effort]\n", "SML3710", "`effort`"),
    ("controller: more command_joints than joints", "controllers", "joints: [shoulder]\n", "joints: [shoulder]\n    command_joints: [shoulder, grip]\n", "SML3710", "more `command_joints`"),
    ("controller: command_joints that are not among the joints", "controllers", "joints: [shoulder]\n", "joints: [shoulder, elbow]\n    command_joints: [grip]\n", "SML3710", "not one of its `joints`"),
    ("controller: two command one joint", "controllers", FORCE, "joints: [shoulder]\n    command_interfaces: [position]\n    state_interfaces: [position]\n", "SML3709", "both command"),
    ("controller: its section is for all nodes", "controllers", ARM, "/**:\n" + textwrap.indent(ARM, "  ").replace("[shoulder]", "[shoulder, wirst]"), "SML3701", "`wirst`"),
    ("controller: its section is in a namespace", "controllers", ARM, "/left/" + ARM.replace("[shoulder]", "[shoulder, wirst]"), "SML3701", "`wirst`"),
    # MoveIt
    ("joint_limits: integer", "limits", "max_velocity: 1.5", "max_velocity: 1", "SML3801", "integer"),
    ("joint_limits: unknown joint", "limits", "  shoulder:\n", "  sholder:\n    has_velocity_limits: false\n  shoulder:\n", "SML3802", "`sholder`"),
    ("joint_limits: has without max", "limits", "    max_velocity: 1.5\n", "", "SML3803", "`max_velocity`"),
    ("joint_limits: faster than the URDF", "limits", "max_velocity: 1.5", "max_velocity: 3.5", "SML3803", "faster"),
    ("joint_limits: beyond the URDF", "limits", "max_position: 0.9", "max_position: 1.9", "SML3803", "beyond"),
    ("joint_limits: positions of a continuous joint", "limits", "joint_limits:\n",
     "joint_limits:\n  wrist: {has_position_limits: true, min_position: -1.0, max_position: 1.0}\n", "SML3803", "continuous"),
    ("kinematics: unknown group", "kinematics", "arm:\n", "amr:\n  kinematics_solver: a/B\narm:\n", "SML3802", "`amr`"),
    ("kinematics: old key", "kinematics", "  kinematics_solver_timeout", "  kinematics_solver_attempts: 3\n  kinematics_solver_timeout", "SML3806", "any more"),
    ("kinematics: timeout 0", "kinematics", "kinematics_solver_timeout: 0.05", "kinematics_solver_timeout: 0.0", "SML3810", "above 0"),
    ("kinematics: integer", "kinematics", "kinematics_solver_timeout: 0.05", "kinematics_solver_timeout: 1", "SML3801", "integer"),
    ("kinematics: negative resolution", "kinematics", "resolution: 0.005", "resolution: -0.005", "SML3810", ""),
    ("moveit_controllers: no controller_names", "moveit", "  controller_names: [arm]\n", "", "SML3804", "no list `controller_names`"),
    ("moveit_controllers: joints of no group", "moveit", "  arm:\n", "  eye:\n    action_ns: turn\n    type: FollowJointTrajectory\n    joints: [mount]\n  arm:\n", "SML3805", "no group of the SRDF"),
    ("moveit_controllers: names are no list", "moveit", "controller_names: [arm]", "controller_names: arm", "SML3804", ""),
    ("moveit_controllers: no section", "moveit", "controller_names: [arm]", "controller_names: [arm, amr]", "SML3804", "no section"),
    ("moveit_controllers: no action_ns", "moveit", "    action_ns: follow_joint_trajectory\n", "", "SML3804", "no `action_ns`"),
    ("moveit_controllers: no type", "moveit", "    type: FollowJointTrajectory\n", "", "SML3804", "type"),
    ("moveit_controllers: unknown type", "moveit", "type: FollowJointTrajectory", "type: FollowJointTrajectories", "SML3804", "unknown type"),
    ("moveit_controllers: no joints", "moveit", "    joints: [shoulder]\n", "", "SML3804", "no list `joints`"),
    ("moveit_controllers: parallel gripper of one joint", "moveit", "type: FollowJointTrajectory", "type: GripperCommand\n    parallel: true", "SML3804", "parallel gripper"),
    ("moveit_controllers: no ros2_controller", "moveit", "[arm]\n  arm:", "[hand]\n  hand:", "SML3805", "no controllers.yaml declares"),
    ("moveit_controllers: other joints", "moveit", "joints: [shoulder]", "joints: [elbow]", "SML3805", "`elbow`"),
    ("ompl_planning: unknown group", "ompl", "arm:\n", "amr:\n  planner_configs: [RRT]\narm:\n", "SML3802", "`amr`"),
    ("ompl_planning: unknown planner", "ompl", "planner_configs: [RRT]", "planner_configs: [RTT]", "SML3807", "`RTT`"),
    ("sensors_3d: no section", "sensors", "sensors: [camera]", "sensors: [camra]", "SML3808", "`camra`"),
    (".setup_assistant: no URDF", "setup", "urdf/lamp.urdf", "urdf/lmp.urdf", "SML3809", "lmp.urdf"),
    (".setup_assistant: no SRDF", "setup", "config/lamp.srdf", "config/lmp.srdf", "SML3809", "lmp.srdf"),
]
# What looks like a mistake, and is none: the part, the file, what is written instead of what.
CALM = [
    ("link_sphere_approximation: radius 0", "srdf", 'radius="0.05"', 'radius="0"'),
    ("elements of HPP", "srdf", "</robot>", '  <gripper name="tool" clearance="0.01"><link name="hand"/></gripper>\n</robot>'),
    ("joint: mimic=\"True\" of Python", "robot", 'mimic="true"', 'mimic="True"'),
    ("joint: parameter mimic", "robot", '<joint name="squeeze" mimic="true">', '<joint name="squeeze">\n      <param name="mimic">grip</param>'),
    ("interface: damping", "robot", WRIST, WRIST.replace('"/>', '"/>\n      <command_interface name="damping"/>')),
    ("parameter: empty", "robot", '<param name="port">/dev/ttyUSB0</param>', '<param name="port"></param>'),
    ("controller: of another robot", "controllers", ARM, ARM.replace("shoulder", "hip")),
    ("controller: placeholders", "controllers", ARM, ARM.replace("[shoulder]", "[$(var prefix)shoulder]")),
    ("joint_limits: integer in ROS 1", "limits", "max_velocity: 1.5", "max_velocity: 1"),
]
ROS_1 = {"joint_limits: integer in ROS 1"}


class CompanionRows(cli.CliTest):
    def setUp(self):
        super().setUp()
        self.enter_workspace()
        self.write("lamp_description/package.xml", cli.package("lamp_description"))
        self.write("lamp_moveit_config/package.xml", cli.package("lamp_moveit_config", "lamp_description"))
        for path, text in FILES.values():
            self.write(path, text)

    def findings(self):
        """(rule, file, message) of the rules about companions"""
        done = self.run_tool("--format", "json", "--min-severity", "info", ".")
        return [(one["id"], one["file"], one["message"]) for one in json.loads(done.stdout)["diagnostics"]
                if "SML3500" <= one["id"] < "SML3900"]

    def test_the_robot_is_clean(self):
        self.assertEqual(self.findings(), [])

    def test_calm(self):
        for name, file, old, new in CALM:
            path, text = FILES[file]
            with self.subTest(name):
                self.assertEqual(text.count(old), 1, old)
                self.write(path, text.replace(old, new))
                if name in ROS_1:
                    self.write("lamp_moveit_config/package.xml", cli.package("lamp_moveit_config", "lamp_description").replace("ament_cmake", "catkin"))
                self.assertEqual(self.findings(), [])
            self.write(path, text)

    def test_every_row_of_the_tables_is_tested(self):
        tests = pathlib.Path(__file__).resolve().parent.parent
        cases = (tests / "verdicts/companion_executed.tsv").read_text(encoding="utf-8").splitlines()
        proofs = {row[0] for row in ROWS} | {row[0] for row in CALM} | {" ".join(line.split("\t")[:2]) for line in cases}
        proofs |= {path.name for path in (cli.FIXTURES / "rules").iterdir() if (path / "bad").is_dir()}
        proofs |= set(re.findall(r"def (test_\w+)", (tests / "cli/companions_test.py").read_text(encoding="utf-8")))
        named = {proof for _, *those in companion_tables.TABLES for proof in those}
        self.assertEqual(sorted(named - proofs), [])
        self.assertEqual(sorted({row[0] for row in ROWS + CALM} - named), [])
        self.assertTrue(all(len(row) > 1 for row in companion_tables.TABLES))

    def test_rows(self):
        names = [row[0] for row in ROWS]
        self.assertEqual(len(set(names)), len(names))
        for name, file, old, new, rule, words, *at in ROWS:
            path, text = FILES[file]
            place = FILES[at[0] if at else file][0]
            with self.subTest(name):
                self.assertEqual(text.count(old), 1, old)
                self.write(path, text.replace(old, new))
                found = self.findings()
                self.assertEqual([one[:2] for one in found], [(rule, place)], found)
                self.assertIn(words, found[0][2])
            self.write(path, text)


if __name__ == "__main__":
    cli.main()
