// SPDX-License-Identifier: BSD-3-Clause
#include "link/companions/parameter_names.hpp"

#include <string_view>

#include "base/words.hpp"
#include "link/reference_finder.hpp"

namespace smurf {
namespace {

void add_text(const Naming& naming, yaml::View value, ReferenceFinder& finder) {
  if (value.is_scalar()) {
    if (!value.text().empty()) finder.add(naming, value.text(), place_of_name(value));
  } else if (value.is_sequence()) {
    for (const yaml::View item : value) {
      if (item.is_scalar() && !item.text().empty()) {
        finder.add(naming, item.text(), place_of_name(item));
      }
    }
  }
}

void add_keys(const Naming& naming, yaml::View value, ReferenceFinder& finder) {
  if (!value.is_mapping()) return;
  for (const yaml::View member : value) {
    if (!member.is_repeated()) finder.add(naming, member.key(), place_of_key(member));
  }
}

/// Whether a parameter of a controller holds names of joints.
bool holds_joints(std::string_view key) {
  return is_one_of(key, {"joints", "joint", "command_joints", "dof_names"}) ||
         key.ends_with("joint_name") || key.ends_with("joints_names") ||
         key.ends_with("joint_names") || key.ends_with("wheel_names") ||
         key.ends_with("wheels_names");
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
    } else if (value.key().ends_with("frame_id") && value.is_scalar()) {
      finder.add_if_known(NameKind::link, value.text(), place_of_name(value));
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
    } else if (is_one_of(member.key(),
                         {"robot_description_kinematics", "ros__parameters", "/**"})) {
      add_of_kinematics(member, finder);
    }
  }
}

void add_of_moveit_controllers(yaml::View root, ReferenceFinder& finder) {
  for (const yaml::View member : root) {
    if (member.is_sequence() && member.key() == "controller_list") {  // ROS 1
      for (const yaml::View controller : member) {
        const yaml::View joints =
            controller.is_mapping() ? controller.find("joints") : yaml::View();
        if (joints) add_text({NameKind::joint}, joints, finder);
      }
    }
    if (!member.is_mapping()) continue;
    if (member.find("controller_names")) {
      for (const yaml::View controller : member) {
        if (!controller.is_mapping()) continue;
        if (const yaml::View joints = controller.find("joints")) {
          add_text({NameKind::joint}, joints, finder);
        }
      }
    } else {
      add_of_moveit_controllers(member, finder);
    }
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
  }
}

}  // namespace smurf
