// SPDX-License-Identifier: BSD-3-Clause
#include "link/companions/parameter_names.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "ast/ros_parameters.hpp"
#include "base/text/words.hpp"
#include "link/reference_finder.hpp"
#include "link/surroundings/frame_names.hpp"

namespace smurf {
namespace {

/// The place of a name that is a part of the text of a scalar.
NamePlace part_of_text(yaml::View scalar, std::string_view name) {
  const auto offset = static_cast<std::size_t>(name.data() - scalar.text().data());
  return part_of(place_of_name(scalar), offset, name.size());
}

/// `pid/shoulder`, `shoulder/position`: the parts that are joints.
void add_interface(std::string_view text, yaml::View scalar, ReferenceFinder& finder) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('/'), text.size());
    const std::string_view part = text.substr(0, end);
    if (!part.empty() && finder.add_if_known(NameKind::joint, part, part_of_text(scalar, part))) {
      return;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

void add_text(const Naming& naming, yaml::View value, ReferenceFinder& finder) {
  if (value.is_scalar()) {
    const std::string_view text = value.text();
    if (text.empty()) return;
    if (text.find('/') != std::string_view::npos && text.front() != '/') {
      add_interface(text, value, finder);
    } else {
      finder.add(naming, text, place_of_name(value));
    }
  } else if (value.is_sequence()) {
    for (const yaml::View item : value) {
      if (item.is_scalar()) add_text(naming, item, finder);
    }
  }
}

/// The names of interfaces in lists and mappings: `interface_names: {force: {x: wrist/force.x}}`.
void add_interfaces(yaml::View value, int depth, ReferenceFinder& finder) {
  constexpr int kDeepest = 4;
  if (value.is_scalar()) {
    if (value.text().find('/') != std::string_view::npos) {
      add_interface(value.text(), value, finder);
    }
  } else if ((value.is_sequence() || value.is_mapping()) && depth < kDeepest) {
    for (const yaml::View one : value) add_interfaces(one, depth + 1, finder);
  }
}

void add_keys(const Naming& naming, yaml::View value, ReferenceFinder& finder) {
  if (!value.is_mapping()) return;
  for (const yaml::View member : value) {
    if (!member.is_repeated()) finder.add(naming, member.key(), place_of_key(member));
  }
}

/// The links and interfaces in the parameters with such a name, at any depth.
void add_names_below(yaml::View value, int depth, ReferenceFinder& finder) {
  constexpr int kDeepest = 4;
  if (may_hold_link(value.key()) && value.is_scalar()) {
    finder.add_if_known(NameKind::link, value.text(), place_of_name(value));
  } else if (value.key().find("interface") != std::string_view::npos) {
    add_interfaces(value, 0, finder);
  } else if (value.is_mapping() && depth < kDeepest) {
    for (const yaml::View member : value) add_names_below(member, depth + 1, finder);
  }
}

/// Parameters whose members have the names of joints.
bool is_by_joint(std::string_view key) { return key == "gains" || key == "constraints"; }

/// Parameters of `constraints` that are not joints.
bool is_constraint(std::string_view key) {
  return is_one_of(key, {"stopped_velocity_tolerance", "goal_time", "decelerate_on_cancel"});
}

void add_of_controller(yaml::View parameters, ReferenceFinder& finder) {
  for (const yaml::View value : parameters) {
    if (value.is_repeated()) continue;
    if (holds_joints(value.key())) {
      add_text({NameKind::joint}, value, finder);
    } else if (is_by_joint(value.key()) && value.is_mapping()) {
      for (const yaml::View member : value) {
        if (member.is_mapping() && !member.is_repeated() && !is_constraint(member.key())) {
          finder.add(may_name(NameKind::joint), member.key(), place_of_key(member));
        }
      }
    } else {
      add_names_below(value, 0, finder);
    }
  }
}

/// The sections of all nodes, at any depth: namespaces are mappings, too.
void add_of_nodes(yaml::View value, int depth, ReferenceFinder& finder) {
  constexpr int kDeepest = 6;
  if (!value.is_mapping() || depth > kDeepest) return;
  for (const yaml::View member : value) {
    if (member.is_repeated()) continue;
    if (member.key() == "ros__parameters") {
      if (member.is_mapping()) add_of_controller(member, finder);
    } else {
      add_of_nodes(member, depth + 1, finder);
    }
  }
}

/// joint_limits.yaml: the mapping `joint_limits`, also below `robot_description_planning`.
void add_of_limits(yaml::View root, ReferenceFinder& finder) {
  for (const yaml::View member : root) {
    if (member.key() == "joint_limits") {
      add_keys({NameKind::joint}, member, finder);
    } else if (member.is_mapping() && member.key() == "robot_description_planning") {
      add_of_limits(member, finder);
    }
  }
}

/// kinematics.yaml: a mapping from groups to solvers.
void add_of_kinematics(yaml::View root, ReferenceFinder& finder) {
  for (const yaml::View member : root) {
    if (member.is_repeated() || !member.is_mapping()) continue;
    if (member.find("kinematics_solver")) {
      finder.add({NameKind::group}, member.key(), place_of_key(member));
      for (const std::string_view key : {"tip_link", "tip_name", "root_link", "root_name"}) {
        const yaml::View link = member.find(key);  // of other solvers
        if (!link || !link.is_scalar()) continue;
        finder.add_if_known(NameKind::link, link.text(), place_of_name(link));
      }
    } else if (is_one_of(member.key(),
                         {"robot_description_kinematics", "ros__parameters", "/**"})) {
      add_of_kinematics(member, finder);
    }
  }
}

/// Controllers of ROS 1 and their hardware, which the setup assistant writes beside the list of
/// MoveIt.
void add_of_ros_control(yaml::View part, ReferenceFinder& finder) {
  const auto add_known = [&](yaml::View scalar) {
    if (scalar.is_scalar()) {
      finder.add_if_known(NameKind::joint, scalar.text(), place_of_name(scalar));
    }
  };
  for (const std::string_view key : {"joints", "joint"}) {
    const yaml::View joints = part.find(key);
    if (!joints) continue;
    add_known(joints);
    if (!joints.is_sequence()) continue;
    for (const yaml::View joint : joints) add_known(joint);
  }
  for (const std::string_view key : {"gains", "constraints", "limits"}) {
    const yaml::View settings = part.find(key);
    if (!settings || !settings.is_mapping()) continue;
    for (const yaml::View one : settings) {
      if (!one.is_repeated()) {
        finder.add_if_known(NameKind::joint, one.key(), place_of_key(one));
      }
    }
  }
}

constexpr std::string_view kMoveitManager = "moveit_simple_controller_manager";

/// The joints of the controllers in a mapping with `controller_names`.
void add_of_moveit_manager(yaml::View manager, ReferenceFinder& finder) {
  for (const yaml::View controller : manager) {
    if (!controller.is_mapping()) continue;
    for (const std::string_view key : {"joints", "command_joint"}) {
      const yaml::View joints = controller.find(key);
      if (joints) add_text({NameKind::joint}, joints, finder);
    }
  }
}

void add_of_moveit_controllers(yaml::View root, ReferenceFinder& finder) {
  if (root.find("controller_names")) return add_of_moveit_manager(root, finder);
  for (const yaml::View member : root) {
    if (member.is_sequence() && member.key() == "controller_list") {  // ROS 1
      for (const yaml::View controller : member) {
        const yaml::View joints =
            controller.is_mapping() ? controller.find("joints") : yaml::View();
        if (joints) add_text({NameKind::joint}, joints, finder);
      }
    }
    if (!member.is_mapping()) continue;
    if (member.find("controller_names") || member.key() == kMoveitManager) {
      add_of_moveit_manager(member, finder);
    } else if (member.find("allowed_start_tolerance_joints")) {
      add_keys({NameKind::joint}, member.find("allowed_start_tolerance_joints"), finder);
    } else {
      add_of_ros_control(member, finder);
      add_of_moveit_controllers(member, finder);
    }
  }
}

/// `joints(shoulder,elbow)` or `link(hand)`: names in a text.
void add_of_projection(yaml::View value, ReferenceFinder& finder) {
  if (!value.is_scalar()) return;
  const std::string_view text = value.text();
  const bool is_link = text.starts_with("link(");
  if (!is_link && !text.starts_with("joints(")) return;
  const std::size_t close = text.find(')');
  for (std::size_t at = text.find('(') + 1; at < std::min(close, text.size());) {
    const std::size_t end = std::min(text.find_first_of(",)", at), text.size());
    const std::string_view name = trimmed(text.substr(at, end - at));
    if (!name.empty()) {
      finder.add({is_link ? NameKind::link : NameKind::joint}, name, part_of_text(value, name));
    }
    at = end + 1;
  }
}

/// ompl_planning.yaml: mappings with `planner_configs` that are lists, except the definitions.
void add_of_planners(yaml::View root, ReferenceFinder& finder) {
  for (const yaml::View member : root) {
    if (member.is_repeated() || !member.is_mapping()) continue;
    const yaml::View planners = member.find("planner_configs");
    if (planners && planners.is_sequence()) {
      finder.add({NameKind::group}, member.key(), place_of_key(member));
    }
    if (const yaml::View projection = member.find("projection_evaluator")) {
      add_of_projection(projection, finder);
    }
  }
}

/// sensors_3d.yaml: the frame of the map.
void add_of_sensors(yaml::View root, ReferenceFinder& finder) {
  const yaml::View frame = root.find("octomap_frame");
  if (frame && frame.is_scalar()) {
    finder.add_if_known(NameKind::link, frame.text(), place_of_name(frame));
  }
}

}  // namespace

void add_parameter_names(const Companion& companion, ReferenceFinder& finder) {
  const yaml::View root = companion.document->view();
  if (!root || !root.is_mapping()) return;
  switch (companion.kind) {
  case CompanionKind::srdf: break;
  case CompanionKind::controllers: add_of_nodes(root, 0, finder); break;
  case CompanionKind::joint_limits: add_of_limits(root, finder); break;
  case CompanionKind::kinematics: add_of_kinematics(root, finder); break;
  case CompanionKind::moveit_controllers: add_of_moveit_controllers(root, finder); break;
  case CompanionKind::ompl_planning: add_of_planners(root, finder); break;
  case CompanionKind::sensors_3d: add_of_sensors(root, finder); break;
  case CompanionKind::setup_assistant: break;
  }
}

}  // namespace smurf
