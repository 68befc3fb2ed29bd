// SPDX-License-Identifier: BSD-3-Clause
// Frames in parameters of navigation2, robot_localization, slam_toolbox and MoveIt Servo.
// Sources: navigation2, robot_localization, slam_toolbox, moveit2, branches humble to rolling.
#include <algorithm>
#include <iterator>
#include <string_view>

#include "base/text/words.hpp"
#include "link/surroundings/frame_names.hpp"

namespace smurf {
namespace {

using Use = FrameName::Use;

/// A key that names a link of the robot, by the node around it; "": any node.
constexpr struct {
  std::string_view node, key;
} kRobotFrames[] = {
    {"", "robot_base_frame"},       {"", "base_frame_id"},
    {"", "base_link_frame"},        {"", "base_link_frame_output"},
    {"slam_toolbox", "base_frame"}, {"docking_server", "base_frame"},
    {"route_server", "base_frame"},
};

/// Keys of frames around the robot.
bool is_outside_key(std::string_view key) {
  return is_one_of(key, {"global_frame", "global_frame_id", "local_frame", "odom_frame_id",
                         "odom_frame", "fixed_frame", "map_frame", "route_frame"});
}

/// Keys of MoveIt Servo that do not end like one of a link.
bool is_other_key(std::string_view key) { return key == "ee_frame_name" || may_hold_link(key); }

void visit_scalar(yaml::View value, std::string_view node, const TakeFrame& take) {
  const std::string_view key = value.key();
  const bool is_of_robot =
      std::any_of(std::begin(kRobotFrames), std::end(kRobotFrames), [&](const auto& one) {
        return one.key == key && (one.node.empty() || one.node == node);
      });
  FrameName frame;
  if (is_of_robot) {
    frame.use = Use::robot;
  } else if (key == "sensor_frame") {
    frame.use = Use::sensor;
  } else if (is_outside_key(key)) {
    frame.use = Use::outside;
  } else if (key == "move_group_name") {
    frame.use = Use::other;
    frame.kinds = NameKind::group;
  } else if (is_other_key(key)) {
    frame.use = Use::other;
  } else {
    return;
  }
  frame.name = value.text();
  frame.place = place_of_name(value);
  frame.written = value.span();
  frame.key = key;
  frame.node = node;
  take(frame);
}

// The recursion is as deep as the file, whose depth is limited.
void visit_mapping(yaml::View value, std::string_view node, const TakeFrame& take) {
  for (const yaml::View member : value) {
    if (member.is_mapping()) {
      const bool is_node = node.empty() || node == "/**";
      visit_mapping(member, is_node && member.key() != "ros__parameters" ? member.key() : node,
                    take);
    } else if (member.is_scalar()) {
      visit_scalar(member, node, take);
    }
  }
}

}  // namespace

bool is_frame_parameters(std::string_view text) {
  const auto has = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
  const bool has_key = has("robot_base_frame") || has("base_frame_id") || has("base_link_frame") ||
                       has("base_frame") || has("move_group_name");
  return has_key && has("ros__parameters") && !has("controller_manager:");
}

void visit_parameters(const FrameFile& file, const TakeFrame& take) {
  const yaml::View root = file.document ? file.document->view() : yaml::View();
  if (root && root.is_mapping()) visit_mapping(root, "", take);
}

}  // namespace smurf
