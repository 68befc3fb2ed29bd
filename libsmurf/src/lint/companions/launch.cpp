// SPDX-License-Identifier: BSD-3-Clause
#include "lint/companions/launch.hpp"

#include <algorithm>
#include <iterator>

#include "base/text/words.hpp"

namespace smurf {
namespace {

constexpr RosPackage kPackages[] = {
    {"robot_state_publisher", "robot_state_publisher"},
    {"joint_state_publisher", "joint_state_publisher"},
    {"joint_state_publisher_gui", "joint_state_publisher_gui"},
    {"rviz2", "rviz2"},
    {"controller_manager", "ros2_control_node spawner unspawner hardware_spawner"},
    {"tf2_ros", "static_transform_publisher buffer_server tf2_echo tf2_monitor"},
    {"ros_gz_sim", "create gzserver set_entity_pose remove"},
    {"ros_gz_bridge", "parameter_bridge static_bridge"},
    {"moveit_ros_move_group", "move_group list_move_group_capabilities"},
    {"gz_ros2_control", ""},
    {"xacro", ""},
};

}  // namespace

std::span<const RosPackage> ros_packages() { return kPackages; }

bool is_ros_package(std::string_view name) {
  return std::any_of(std::begin(kPackages), std::end(kPackages),
                     [&](const RosPackage& one) { return one.name == name; });
}

void for_each_launch(const Companions& companions,
                     const std::function<void(const LaunchFile&)>& visit) {
  for (const LaunchFile& one : companions.surroundings.launch_files) visit(one);
}

std::string_view xacro_call(const LaunchFile& launch) {
  if (launch.form == LaunchFile::Form::python) return "`Command(['xacro ', path])`";
  return launch.is_ros1 ? "`command=\"xacro PATH\"`" : "`$(command 'xacro PATH')`";
}

bool runs(const LaunchNode& node, std::string_view package, std::string_view executable) {
  return node.package.is_known && node.executable.is_known && node.package.text == package &&
         node.executable.text == executable;
}

bool is_published_elsewhere(const Surroundings& surroundings, std::string_view frame) {
  for (const LaunchFile& launch : surroundings.launch_files) {
    for (const LaunchNode& node : launch.nodes) {
      const auto transform = static_transform_of(node);
      if (transform && transform->child != nullptr && transform->child->text == frame) return true;
    }
  }
  const std::string quoted = "\"" + std::string(frame) + "\"";
  return std::any_of(surroundings.other_robots.begin(), surroundings.other_robots.end(),
                     [&](const std::string& text) {
                       return text.find(quoted) != std::string::npos ||
                              text.find("}" + std::string(frame) + "\"") != std::string::npos;
                     });
}

}  // namespace smurf
